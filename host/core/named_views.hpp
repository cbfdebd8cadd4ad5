// All images of a call with what errors call them.
#pragma once

#include <array>
#include <iterator>
#include <quell/error.hpp>
#include <quell/frame.hpp>
#include <string>

#include "host/core/image_schema.hpp"

namespace quell {

struct NamedView {
  std::string name;  ///< "albedo", "output.linear"
  const ImageView* view;
  const ImageFacts* facts;
  bool output;
};

/// An array: every frame is checked, and large blocks of the heap come and go slowly.
using NamedViews = std::array<NamedView, std::size(kInputs<Frame>) + std::size(kOutputs<Output>)>;

/// Inputs, then outputs; those that are absent as well. Refers to the arguments.
inline NamedViews namedViews(const Frame& frame, const Output& output) {
  NamedViews views;
  std::size_t next = 0;
  for (const auto& image : kInputs<Frame>)
    views[next++] = {image.name, &(frame.*image.member), &image, false};
  for (const auto& image : kOutputs<Output>)
    views[next++] = {std::string("output.") + image.name, &(output.*image.member), &image, true};
  return views;
}

[[noreturn]] inline void refuse(const char* function, ErrorCode code, const std::string& buffer,
                                const std::string& expected, const std::string& got) {
  throw Error(code, {function, buffer, expected, got});
}

inline std::string sizeText(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// Whether kernels that are compiled for one can read or write the other.
inline bool samePixels(const ImageView& a, const ImageView& b) {
  if (a.present() != b.present()) return false;
  if (!a.present()) return true;
  if (a.format != b.format || a.channels != b.channels || a.sum != b.sum) return false;
  return a.isImageObject() || a.pixelStride() == b.pixelStride();
}

/// Whether their rows lie alike as well.
inline bool sameLayout(const ImageView& a, const ImageView& b, int width) {
  if (!samePixels(a, b)) return false;
  if (!a.present()) return true;
  if (a.isImageObject()) return (a.rowPitchBytes < 0) == (b.rowPitchBytes < 0);
  return a.rowPitch(width) == b.rowPitch(width);
}

}  // namespace quell
