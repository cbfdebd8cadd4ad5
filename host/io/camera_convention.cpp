#include "host/io/camera_convention.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/io/least_median.hpp"

namespace quell::io {
namespace {

/// Enough for a median.
constexpr double kMostSamples = 4096.0;
constexpr double kFitPx = 2.0;
/// Of the shorter side: about where pixels of a random matrix would be too near.
constexpr double kFitShare = 0.05;

double clipRow(const Matrix4& m, std::size_t row, const float* p) {
  return m[4 * row] * double(p[0]) + m[4 * row + 1] * double(p[1]) + m[4 * row + 2] * double(p[2]) +
         m[4 * row + 3];
}

bool isSurface(const float* p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) &&
         !(p[0] == 0.0f && p[1] == 0.0f && p[2] == 0.0f);
}

}  // namespace

const std::vector<MatrixReading>& matrixReadings() {
  static const std::vector<MatrixReading> all = {{"as it stands", false, false},
                                                 {"transposed", true, false},
                                                 {"with y down", false, true},
                                                 {"transposed, with y down", true, true}};
  return all;
}

Matrix4 readAs(const MatrixReading& reading, const Matrix4& matrix) {
  Matrix4 result{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      result[4 * row + column] = (reading.yDown && row == 1 ? -1.0 : 1.0) *
                                 matrix[reading.transposed ? 4 * column + row : 4 * row + column];
  return result;
}

std::optional<double> projectionErrorPx(const Matrix4& worldToClip, const std::array<double, 2>& jitterPx,
                                        const Image& position) {
  const int step =
      std::max(1, int(std::ceil(std::sqrt(double(position.width) * position.height / kMostSamples))));
  std::vector<double> distances;
  for (int y = step / 2; y < position.height; y += step) {
    for (int x = step / 2; x < position.width; x += step) {
      const float* p = &position.pixels[3 * (std::size_t(y) * std::size_t(position.width) + std::size_t(x))];
      if (!isSurface(p)) continue;
      const double w = clipRow(worldToClip, 3, p);
      const double column = (0.5 + 0.5 * clipRow(worldToClip, 0, p) / w) * position.width;
      const double row = (0.5 - 0.5 * clipRow(worldToClip, 1, p) / w) * position.height;
      const double distance = std::hypot(column - (x + 0.5 + jitterPx[0]), row - (y + 0.5 + jitterPx[1]));
      distances.push_back(w > 0.0 && std::isfinite(distance) ? distance
                                                             : std::numeric_limits<double>::infinity());
    }
  }
  if (distances.empty()) return std::nullopt;
  return middleValue(std::move(distances));
}

bool fits(double errorPx, const Image& picture) {
  return errorPx < std::min(kFitPx, kFitShare * std::min(picture.width, picture.height));
}

}  // namespace quell::io
