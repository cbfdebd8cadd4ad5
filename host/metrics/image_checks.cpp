#include "host/metrics/image_checks.hpp"

#include <fmt/format.h>

#include <quell/error.hpp>

namespace quell::metrics {
namespace {

std::string shapeOf(const io::Image& image) {
  return fmt::format("{}x{} pixels of {} channels", image.width, image.height, image.channels);
}

}  // namespace

void requireComparable(const io::Image& image, const io::Image& reference, const std::string& measure) {
  if (reference.empty() || reference.channels != kRgbChannels)
    throw Error(ErrorCode::InvalidArgument,
                {measure, "reference", "an image of 3 channels", shapeOf(reference)});
  if (image.width != reference.width || image.height != reference.height || image.channels != kRgbChannels)
    throw Error(ErrorCode::InvalidArgument,
                {measure, "image", "the reference's " + shapeOf(reference), shapeOf(image)});
}

}  // namespace quell::metrics
