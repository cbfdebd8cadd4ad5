// Whether a renderer sends its primary rays through pixel centres.
#pragma once

#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// Distance of a surface's position, projected into the image, from where the frame's camera says that rays go: mean over a
/// sample of the pixels, in pixels. 0 where there are no positions.
double rayOffsetPx(const io::FrameData& frame);

/// Mean distance up to which rays count as centred, pixels: positions in half precision are off by a few hundredths, rays
/// that go anywhere in their pixel by .38. Most renderers jitter every sample and say so nowhere.
constexpr double kCentredRaysPx = 0.15;

}  // namespace quell::cli
