// How an image of the caller lies in device memory.
#pragma once

#include <CL/cl.h>

#include <cstddef>
#include <cstdint>

namespace quell {

/// Pixel extent, both >= 1.
struct Size {
  int width = 0;   ///< pixels across
  int height = 0;  ///< pixels down
};

/// Whether both extents are the same.
inline bool operator==(Size a, Size b) { return a.width == b.width && a.height == b.height; }
/// Whether one of them is not.
inline bool operator!=(Size a, Size b) { return !(a == b); }

/// What the components of an image are in memory.
enum class ComponentFormat : std::uint8_t {
  Float32,      ///< IEEE single
  Float16,      ///< IEEE half
  UInt32,       ///< 32-bit unsigned integers, for object ids only
  ImageObject,  ///< `memory` is an OpenCL image of two dimensions, not a buffer
};

/// What a pixel of an input holds where a renderer adds up samples.
enum class Sum : std::uint8_t {
  None,           ///< its value
  CountInFourth,  ///< the sum of the values, and their number in the fourth component; no sample, no value (NaN)
  OverSampleCount,  ///< the sum of Frame::sampleCount values
};

/// One image that the caller owns, in a buffer or as an OpenCL image object. Row-major, pixel (0, 0) is top left. Packed
/// float3, float4, planar single components and interleaved structs are all described by the strides. Only the stated
/// components are read or written. A view without `channels` stands for an absent optional image.
///
/// Image objects hold floats, halves or normalised 8- or 16-bit integers, which OpenCL converts, those of object ids also
/// integers of 8, 16 or 32 bits; they may be larger than the frame, which is read from and written to their corner at
/// (0, 0). Inputs are copied into buffers first, outputs written directly; images shared with another API have to be
/// acquired by the caller.
struct ImageView {
  cl_mem memory = nullptr;  ///< buffer or image object on the denoiser's context; not retained
  ComponentFormat format = ComponentFormat::Float32;  ///< ImageObject: the image knows its own
  Sum sum = Sum::None;                                ///< inputs only, but object ids
  int channels = 0;                                   ///< components used per pixel, 1 to 4; 0: absent
  std::size_t offsetBytes = 0;  ///< of pixel (0, 0); a multiple of the component size; 0 for image objects
  /// From one pixel to the next; 0: packed. Of image objects, which know it themselves, 0.
  std::size_t pixelStrideBytes = 0;
  /// From one row to the next below it; 0: width times the pixel stride. Negative: rows lie bottom-up, so that pixel
  /// (0, 0) begins the last row of the memory; bottomUp() sets both. Of image objects 0, or negative for bottom-up.
  std::ptrdiff_t rowPitchBytes = 0;

  /// Whether there is such an image.
  bool present() const { return channels != 0; }
  /// Whether `memory` is an OpenCL image instead of a buffer.
  bool isImageObject() const { return format == ComponentFormat::ImageObject; }
  /// Bytes of a component in a buffer, 2 or 4; of no meaning for image objects, as all that follow.
  std::size_t componentBytes() const { return format == ComponentFormat::Float16 ? 2 : 4; }
  /// Bytes from one pixel to the next, `pixelStrideBytes` or what packed pixels take.
  std::size_t pixelStride() const {
    return pixelStrideBytes != 0 ? pixelStrideBytes : componentBytes() * static_cast<std::size_t>(channels);
  }
  /// Bytes from one row to the next below it in an image of that many pixels across; negative for bottom-up rows.
  std::ptrdiff_t rowPitch(int width) const {
    return rowPitchBytes != 0 ? rowPitchBytes
                              : static_cast<std::ptrdiff_t>(pixelStride() * static_cast<std::size_t>(width));
  }
  /// Bytes from the first of a row to the last.
  std::size_t rowBytes(int width) const {
    return static_cast<std::size_t>(width - 1) * pixelStride() +
           componentBytes() * static_cast<std::size_t>(channels);
  }
  /// Bytes that the buffer must hold for an image of this size.
  std::size_t requiredBytes(Size size) const {
    const std::size_t last = rowPitch(size.width) > 0 ? static_cast<std::size_t>(size.height - 1) *
                                                            static_cast<std::size_t>(rowPitch(size.width))
                                                      : 0;
    return offsetBytes + last + rowBytes(size.width);
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

/// An OpenCL image object, of which `channels` components count. `memory` may be null as above.
inline ImageView imageObject(cl_mem memory, int channels) {
  return packedImage(memory, channels, ComponentFormat::ImageObject);
}

/// The same memory with its rows bottom-up, as OpenGL has them: `view` says where the memory's first row is, which now is
/// the lowest of the picture.
inline ImageView bottomUp(ImageView view, Size size) {
  if (view.isImageObject()) {
    view.rowPitchBytes = -1;
    return view;
  }
  const std::ptrdiff_t pitch = view.rowPitch(size.width);
  view.offsetBytes += static_cast<std::size_t>(size.height - 1) * static_cast<std::size_t>(pitch);
  view.rowPitchBytes = -pitch;
  return view;
}

/// A view whose pixels are sums; see Sum.
inline ImageView summed(ImageView view, Sum sum = Sum::CountInFourth) {
  view.sum = sum;
  return view;
}

}  // namespace quell
