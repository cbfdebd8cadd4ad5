#include "host/io/position_depth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "host/io/depth_kind.hpp"
#include "host/io/least_median.hpp"
#include "host/io/least_squares.hpp"

namespace quell::io {
namespace {

constexpr std::size_t kUnknowns =
    11;  // of three rows of four, the last of which is 1 in the middle of the scene
/// More samples than this make depth no better.
constexpr int kMostSamples = 1 << 13;
constexpr int kRefinements = 4;
/// Samples farther from their pixels than so many medians, and than so much of half the picture, count for nothing.
constexpr double kNearMedians = 3.0, kNearNdc = 0.02;
/// Least change of depth over the extent of the scene, as a share of the depth in its middle: less is no perspective.
constexpr double kLeastPerspective = 1e-3;

struct Sample {
  std::array<double, 4> position;  ///< from the middle of the scene, in units of its extent, and 1
  double x, y;                     ///< of the pixel, from -1 to 1
};
using Samples = std::vector<Sample>;
using Rows = std::array<std::array<double, 4>, 3>;  ///< x and y times depth, and depth

double at(const std::array<double, 4>& row, const Sample& sample) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) sum += row[i] * sample.position[i];
  return sum;
}

/// Where the rows put the sample, from where it is; infinite behind the camera.
double distance(const Rows& rows, const Sample& sample) {
  const double depth = at(rows[2], sample);
  if (!(depth > 0.0)) return std::numeric_limits<double>::infinity();
  return std::hypot(at(rows[0], sample) / depth - sample.x, at(rows[1], sample) / depth - sample.y);
}

double medianDistance(const Rows& rows, const Samples& samples) {
  std::vector<double> all;
  for (const Sample& sample : samples) all.push_back(distance(rows, sample));
  return middleValue(std::move(all));
}

/// Samples weigh by 1 / depth^2 of the rows `before`, if there are any, so that errors count on the picture.
std::optional<Rows> fitRows(const Samples& samples, const Rows* before) {
  LeastSquares<kUnknowns> squares;
  for (const Sample& sample : samples) {
    const double depth = before == nullptr ? 1.0 : at((*before)[2], sample);
    for (const bool isX : {true, false}) {
      const double ndc = isX ? sample.x : sample.y;
      LeastSquares<kUnknowns>::Row row{};
      for (std::size_t i = 0; i < 4; ++i) row[(isX ? 0 : 4) + i] = sample.position[i];
      for (std::size_t i = 0; i < 3; ++i) row[8 + i] = -ndc * sample.position[i];
      row[kUnknowns] = ndc;
      squares.add(row, 1.0 / (depth * depth));
    }
  }
  const auto found = squares.solve();
  if (!found) return std::nullopt;
  Rows rows{};
  for (std::size_t i = 0; i < kUnknowns; ++i) rows[i / 4][i % 4] = (*found)[i];
  rows[2][3] = 1.0;
  return rows;
}

Samples nearSamples(const Samples& samples, const Rows& rows) {
  const double limit = std::min(kNearNdc, kNearMedians * medianDistance(rows, samples) + 1e-9);
  Samples near;
  for (const Sample& sample : samples)
    if (distance(rows, sample) <= limit) near.push_back(sample);
  return near;
}

std::optional<Rows> robustRows(const Samples& samples) {
  if (samples.size() < kSubset) return std::nullopt;
  auto best = leastMedian(
      samples, [](const Samples& subset) { return fitRows(subset, nullptr); },
      [&](const Rows& rows) { return medianDistance(rows, samples); });
  if (best && !std::isfinite(medianDistance(*best, samples))) return std::nullopt;  // behind the camera
  for (int i = 0; i < kRefinements && best; ++i) best = fitRows(nearSamples(samples, *best), &*best);
  return best;
}

/// What makes positions samples.
struct Scale {
  std::array<double, 3> middle{};
  double extent = 0.0;
};

bool isSurface(const Image& position, const Image& normal, int x, int y) {
  bool any = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(position.at(x, y, axis)) || !std::isfinite(normal.at(x, y, axis))) return false;
    any = any || normal.at(x, y, axis) != 0.0f;
  }
  return any;
}

template <class Visit>
void forEachSurface(const Image& position, const Image& normal, int step, const Visit& visit) {
  for (int y = step / 2; y < position.height; y += step)
    for (int x = step / 2; x < position.width; x += step)
      if (isSurface(position, normal, x, y)) visit(x, y);
}

/// Medians, which a few broken positions do not move.
Scale scaleOf(const Image& position, const Image& normal, int step) {
  Scale scale;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    forEachSurface(position, normal, step, [&](int x, int y) { values.push_back(position.at(x, y, axis)); });
    if (values.empty()) return scale;
    const double centre = scale.middle[std::size_t(axis)] = middleValue(values);
    for (double& value : values) value = std::abs(value - centre);
    scale.extent = std::hypot(scale.extent, middleValue(std::move(values)));
  }
  return scale;
}

Sample sampleOf(const Image& position, const Scale& scale, int x, int y) {
  Sample sample{
      {0.0, 0.0, 0.0, 1.0}, (2.0 * x + 1.0) / position.width - 1.0, 1.0 - (2.0 * y + 1.0) / position.height};
  for (std::size_t i = 0; i < 3; ++i)
    sample.position[i] = (double(position.at(x, y, int(i))) - scale.middle[i]) / scale.extent;
  return sample;
}

}  // namespace

Image viewDepthFromPositions(const Image& position, const Image& normal) {
  const int step = int(std::ceil(std::sqrt(double(position.width) * position.height / kMostSamples)));
  const Scale scale = scaleOf(position, normal, step);
  Samples samples;
  if (scale.extent > 0.0)
    forEachSurface(position, normal, step,
                   [&](int x, int y) { samples.push_back(sampleOf(position, scale, x, y)); });
  const auto rows = robustRows(samples);
  const double slope = rows ? std::hypot((*rows)[2][0], (*rows)[2][1], (*rows)[2][2]) : 0.0;
  Image depth(position.width, position.height, 1, kNoSurfaceDepth);
  forEachSurface(position, normal, 1, [&](int x, int y) {
    const bool known = slope > kLeastPerspective;
    // One unit along the view axis changes the depth by one.
    const double found = known ? at((*rows)[2], sampleOf(position, scale, x, y)) * scale.extent / slope : 1.0;
    depth.at(x, y, 0) = found > 0.0 ? float(found) : kNoSurfaceDepth;
  });
  return depth;
}

}  // namespace quell::io
