// Host images to and from the layouts that callers may use.
#pragma once

#include <quell/image_view.hpp>
#include <string>
#include <vector>

#include "host/io/image.hpp"

namespace quell::tests {

/// A layout of a caller's image, in components.
struct ImageLayout {
  ComponentFormat format = ComponentFormat::Float32;
  int channels = 3;
  int pixelStride = 0;  ///< 0: packed
  int rowPadding = 0;   ///< components between rows
  int offset = 0;       ///< components before the first pixel
};

/// Packed floats.
inline ImageLayout packed(int channels) { return {ComponentFormat::Float32, channels, 0, 0, 0}; }
/// Packed halves.
inline ImageLayout packedHalf(int channels) { return {ComponentFormat::Float16, channels, 0, 0, 0}; }
/// Part of a struct of seven components, with an offset and padded rows: no two loads are alike.
inline ImageLayout interleaved(int channels, ComponentFormat format = ComponentFormat::Float32) {
  return {format, channels, 7, 11, 5};
}

/// "float3", "half4.7+11@5"
std::string describe(const ImageLayout& layout);

/// The view of an image in this layout, without memory.
ImageView makeView(const ImageLayout& layout, Size size);

/// A buffer with the image in it. Missing channels of the image are 0; bytes that belong to no component get
/// a pattern.
std::vector<unsigned char> encodeImage(const io::Image& image, const ImageView& view, Size size);
io::Image decodeImage(const std::vector<unsigned char>& bytes, const ImageView& view, Size size);

/// True if all bytes that belong to no component still hold the pattern.
bool gapsUntouched(const std::vector<unsigned char>& bytes, const ImageView& view, Size size);

/// What a device reads from this layout: rounded to half where halves are stored, and cut to its channels.
io::Image asStored(const io::Image& image, const ImageView& view);

}  // namespace quell::tests
