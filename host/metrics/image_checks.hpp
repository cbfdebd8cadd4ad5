// What every error measure asks of the images it compares.
#pragma once

#include <string>

#include "host/io/image.hpp"

namespace quell::metrics {

constexpr int kRgbChannels = 3;

/// Throws Error(InvalidArgument), with `measure` as the stage, unless both images have the same size, 3
/// channels and at least one pixel.
void requireComparable(const io::Image& image, const io::Image& reference, const std::string& measure);

}  // namespace quell::metrics
