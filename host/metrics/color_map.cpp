#include "host/metrics/color_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quell::metrics {
namespace {

using Rgb = std::array<float, 3>;

/// Ramp at equal steps from 0 to 1, display-encoded; chosen by eye so that Rec. 709 luma rises by about 0.19
/// a step.
constexpr std::array<Rgb, 6> kRamp = {{{0.00f, 0.00f, 0.02f},
                                       {0.34f, 0.08f, 0.52f},
                                       {0.77f, 0.24f, 0.45f},
                                       {0.97f, 0.49f, 0.29f},
                                       {1.00f, 0.76f, 0.34f},
                                       {1.00f, 0.97f, 0.78f}}};
constexpr Rgb kNanColor = {0.0f, 1.0f, 0.0f};

Rgb rampColor(float value) {
  if (std::isnan(value)) return kNanColor;
  const float position = std::clamp(value, 0.0f, 1.0f) * float(kRamp.size() - 1);
  const std::size_t below = std::min(std::size_t(position), kRamp.size() - 2);
  const float share = position - float(below);
  Rgb color{};
  for (std::size_t c = 0; c < color.size(); ++c)
    color[c] = (1.0f - share) * kRamp[below][c] + share * kRamp[below + 1][c];
  return color;
}

}  // namespace

io::Image colorizeMap(const io::Image& map) {
  io::Image picture(map.width, map.height, 3);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const Rgb color = rampColor(map.at(x, y, 0));
      for (int c = 0; c < 3; ++c) picture.at(x, y, c) = color[std::size_t(c)];
    }
  return picture;
}

}  // namespace quell::metrics
