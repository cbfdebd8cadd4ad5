#include "host/cli/common/ray_jitter.hpp"

#include <cmath>

namespace quell::cli {
namespace {

// Pixels between those that are looked at, along each axis.
constexpr int kStride = 5;

// Nothing for what is behind the camera or not finite.
std::optional<double> offsetAt(const io::FrameData& frame, int x, int y) {
  const auto row = [&](std::size_t r) {
    const double* m = &frame.camera.worldToClip[4 * r];
    return m[0] * double(frame.positionWorld.at(x, y, 0)) + m[1] * double(frame.positionWorld.at(x, y, 1)) +
           m[2] * double(frame.positionWorld.at(x, y, 2)) + m[3];
  };
  const double w = row(3);
  if (!(w > 0.0)) return std::nullopt;
  const double column = (0.5 + 0.5 * row(0) / w) * frame.positionWorld.width;
  const double line = (0.5 - 0.5 * row(1) / w) * frame.positionWorld.height;
  const double offset =
      std::hypot(column - (x + 0.5 + frame.camera.jitterPx[0]), line - (y + 0.5 + frame.camera.jitterPx[1]));
  // Farther than a pixel filter reaches: a camera that does not fit, which is not this function's matter.
  return offset <= 2.0 ? std::optional<double>(offset) : std::nullopt;
}

bool isSurface(const io::FrameData& frame, int x, int y) {
  double squared = 0.0;
  for (int c = 0; c < 3; ++c) squared += std::pow(double(frame.normalWorld.at(x, y, c)), 2.0);
  return squared > 0.0;
}

}  // namespace

double rayOffsetPx(const io::FrameData& frame) {
  if (frame.positionWorld.empty() || frame.normalWorld.empty()) return 0.0;
  double sum = 0.0;
  int count = 0;
  for (int y = kStride / 2; y < frame.positionWorld.height; y += kStride)
    for (int x = kStride / 2; x < frame.positionWorld.width; x += kStride) {
      const auto offset = isSurface(frame, x, y) ? offsetAt(frame, x, y) : std::nullopt;
      if (!offset) continue;
      sum += *offset;
      ++count;
    }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace quell::cli
