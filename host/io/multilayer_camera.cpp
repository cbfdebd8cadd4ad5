#include "host/io/multilayer_camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "host/io/least_median.hpp"

namespace quell::io {
namespace {

using Vector3 = std::array<double, 3>;

/// More samples than this make a camera no better.
constexpr int kMostSamples = 1 << 18;

bool isSurface(const Image& depth, int x, int y) {
  const float d = depth.at(x, y, 0);
  return d > 0.0f && d < kSkyDepth;  // false for NaN
}

Vector3 positionAt(const Image& image, int x, int y) {
  return {double(image.at(x, y, 0)), double(image.at(x, y, 1)), double(image.at(x, y, 2))};
}

double ndcX(const Image& image, int x) { return (2.0 * x + 1.0) / image.width - 1.0; }
double ndcY(const Image& image, int y) { return 1.0 - (2.0 * y + 1.0) / image.height; }

bool isFinite(const Vector3& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

/// Surfaces with a position, of all pixels or of a regular grid of them.
std::vector<CameraSample> samplesOf(const Image& position, const Image& depth) {
  std::vector<CameraSample> samples;
  const double pixels = double(depth.width) * double(depth.height);
  const int step = int(std::ceil(std::sqrt(pixels / kMostSamples)));
  for (int y = step / 2; y < depth.height; y += step)
    for (int x = step / 2; x < depth.width; x += step)
      if (const Vector3 p = positionAt(position, x, y); isSurface(depth, x, y) && isFinite(p))
        samples.push_back({p, ndcX(depth, x), ndcY(depth, y), double(depth.at(x, y, 0))});
  return samples;
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector3 scaled(const Vector3& a, double factor) { return {a[0] * factor, a[1] * factor, a[2] * factor}; }
Vector3 unit(const Vector3& a) { return scaled(a, 1.0 / std::sqrt(dot(a, a))); }

}  // namespace

FoundCamera findCamera(const Image& positionWorld, const Image& depth) {
  return fitCamera(samplesOf(positionWorld, depth), depth.width, depth.height);
}

Matrix4 standInCamera(const Image& positionWorld, const Image& normalWorld, const Image& depth) {
  const std::vector<CameraSample> samples = samplesOf(positionWorld, depth);
  const auto median = [&](const auto& valueOf) {
    std::vector<double> values;
    for (const CameraSample& sample : samples) values.push_back(valueOf(sample));
    return values.empty() ? 0.0 : middleValue(std::move(values));
  };
  Vector3 centre{}, axis{};
  for (std::size_t i = 0; i < 3; ++i)
    centre[i] = median([&](const CameraSample& sample) { return sample.position[i]; });
  for (std::size_t i = 0; i < normalWorld.pixels.size(); ++i)
    if (std::isfinite(normalWorld.pixels[i])) axis[i % 3] -= double(normalWorld.pixels[i]);
  axis = dot(axis, axis) > 0.0 ? unit(axis) : Vector3{0.0, 0.0, -1.0};
  const Vector3 up = std::abs(axis[2]) < 0.9 ? Vector3{0.0, 0.0, 1.0} : Vector3{0.0, 1.0, 0.0};
  const Vector3 right = unit(cross(axis, up));
  const Vector3 rows[] = {right, scaled(cross(right, axis), double(depth.width) / depth.height), {}, axis};
  Matrix4 matrix{};
  for (std::size_t row = 0; row < 4; ++row) {
    std::copy(rows[row].begin(), rows[row].end(), matrix.begin() + std::ptrdiff_t(4 * row));
    matrix[4 * row + 3] = -dot(rows[row], centre);
  }
  matrix[15] += samples.empty() ? 1.0 : median([](const CameraSample& sample) { return sample.depth; });
  return matrix;
}

std::optional<Image> positionsFromDepth(const Matrix4& m, const Image& depth) {
  const Vector3 rowX = {m[0], m[1], m[2]}, rowY = {m[4], m[5], m[6]}, rowW = {m[12], m[13], m[14]};
  const double unit = std::sqrt(dot(rowW, rowW));  // clip.w at view depth 1
  const double determinant = dot(rowX, cross(rowY, rowW));
  if (!(std::abs(determinant) > 0.0)) return std::nullopt;
  const Vector3 byX = cross(rowY, rowW), byY = cross(rowW, rowX), byW = cross(rowX, rowY);
  Image position(depth.width, depth.height, 3);
  for (int y = 0; y < depth.height; ++y) {
    for (int x = 0; x < depth.width; ++x) {
      if (!isSurface(depth, x, y)) continue;
      const double w = double(depth.at(x, y, 0)) * unit;
      const double rightX = ndcX(depth, x) * w - m[3], rightY = ndcY(depth, y) * w - m[7];
      const double rightW = w - m[15];
      for (std::size_t axis = 0; axis < 3; ++axis)
        position.at(x, y, int(axis)) =
            float((rightX * byX[axis] + rightY * byY[axis] + rightW * byW[axis]) / determinant);
    }
  }
  return position;
}

}  // namespace quell::io
