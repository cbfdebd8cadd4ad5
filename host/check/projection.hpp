// How far surfaces are from where a camera puts them.
#pragma once

#include <vector>

#include "host/check/context.hpp"

namespace quell::check {

/// From where rays go by the camera's jitter to where `worldToClip` puts each surface, pixels, x right, y down; infinite
/// behind the camera.
std::vector<glm::dvec2> offsetsPx(const Context& context, const Matrix4& worldToClip);
std::vector<double> lengthsOf(const std::vector<glm::dvec2>& offsets);
/// Middle of each component.
glm::dvec2 medianOf(const std::vector<glm::dvec2>& offsets);

/// Distance of a surface's position, projected into the image, from where the frame's camera says that rays go: mean over
/// a sample of the pixels, in pixels. 0 where there are no positions.
double rayOffsetPx(const Frame& frame);

/// Mean distance up to which rays count as centred, pixels: positions in half precision are off by a few hundredths, rays
/// that go anywhere in their pixel by .38. Most renderers jitter every sample and say so nowhere.
constexpr double kCentredRaysPx = 0.15;

/// Largest median distance of a camera that fits, pixels: the widest pixel filters in use.
constexpr double kFittingPx = 3.0;

}  // namespace quell::check
