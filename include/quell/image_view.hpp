// How an image of the caller lies in device memory.
#pragma once

#include <CL/cl.h>

#include <cstddef>
#include <cstdint>

namespace quell {

/// Pixel extent, both >= 1.
struct Size {
  int width = 0;
  int height = 0;
};

inline bool operator==(Size a, Size b) { return a.width == b.width && a.height == b.height; }
inline bool operator!=(Size a, Size b) { return !(a == b); }

enum class ComponentFormat : std::uint8_t {
  Float32,
  Float16,  ///< IEEE half
  UInt32,   ///< 32-bit unsigned integers, for object ids only
};

/// One image within a buffer that the caller owns. Row-major, pixel (0, 0) is top left. Packed float3,
/// float4, planar single components and interleaved structs are all described by the strides. Only the stated
/// components are read or written. A view without `channels` stands for an absent optional image.
struct ImageView {
  cl_mem memory = nullptr;  ///< buffer object on the denoiser's context; not retained
  ComponentFormat format = ComponentFormat::Float32;
  int channels = 0;                  ///< components used per pixel, 1 to 4; 0: absent
  std::size_t offsetBytes = 0;       ///< of pixel (0, 0); a multiple of the component size
  std::size_t pixelStrideBytes = 0;  ///< from one pixel to the next; 0: packed
  std::size_t rowPitchBytes = 0;     ///< from one row to the next; 0: width times the pixel stride

  bool present() const { return channels != 0; }
  std::size_t componentBytes() const { return format == ComponentFormat::Float16 ? 2 : 4; }
  std::size_t pixelStride() const {
    return pixelStrideBytes != 0 ? pixelStrideBytes : componentBytes() * static_cast<std::size_t>(channels);
  }
  std::size_t rowPitch(int width) const {
    return rowPitchBytes != 0 ? rowPitchBytes : pixelStride() * static_cast<std::size_t>(width);
  }
  /// Bytes that the buffer must hold for an image of this size.
  std::size_t requiredBytes(Size size) const {
    return offsetBytes + static_cast<std::size_t>(size.height - 1) * rowPitch(size.width) +
           static_cast<std::size_t>(size.width - 1) * pixelStride() +
           componentBytes() * static_cast<std::size_t>(channels);
  }
};

/// A packed image at the start of a buffer. `memory` may be null where only the layout matters
/// (Denoiser::prepare).
inline ImageView packedImage(cl_mem memory, int channels, ComponentFormat format = ComponentFormat::Float32) {
  ImageView view;
  view.memory = memory;
  view.channels = channels;
  view.format = format;
  return view;
}

}  // namespace quell
