#include "host/io/camera_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/io/least_median.hpp"

namespace quell::io {
namespace {

constexpr int kUnknowns = 4;  // of a row: three for the position, one constant
constexpr int kRows = 3;      // clip x, y and w
/// Share of the scene's variance across a plane below which it is one plane: rounding of half floats.
constexpr double kFlatShare = 1e-5;
/// Largest root mean square distance of projected positions from their pixels.
constexpr double kFitPx = 2.0;
/// Samples farther away than this, and than so many medians, are left out: Cycles averages over a filter of 1.5 px.
constexpr double kNearPx = 3.0, kNearMedians = 3.0;
/// Largest error of a depth, as a share of it.
constexpr double kDepthShare = 0.1;
/// Samples that judge the cameras of subsets.
constexpr std::size_t kJudges = 4096;
constexpr int kRefinements = 3;

using Samples = std::vector<CameraSample>;
using Vector3 = std::array<double, 3>;

/// Centre and extent of the positions: the fit is done in these units.
struct Scale {
  Vector3 centre{};
  double size = 0.0;
};

Scale scaleOf(const Samples& samples) {
  Scale scale;
  double squares = 0.0;
  const double count = double(samples.size());
  for (const CameraSample& sample : samples)
    for (std::size_t i = 0; i < 3; ++i) scale.centre[i] += sample.position[i] / count;
  for (const CameraSample& sample : samples)
    for (std::size_t i = 0; i < 3; ++i) squares += std::pow(sample.position[i] - scale.centre[i], 2.0);
  scale.size = std::sqrt(squares / count);
  return scale;
}

/// Normal equations of the three rows side by side.
struct Equations {
  double left[kUnknowns][kUnknowns] = {};
  double right[kUnknowns][kRows] = {};
};

/// Gaussian elimination; the solution replaces `right`. False if a pivot vanishes.
bool solve(Equations& e) {
  for (int column = 0; column < kUnknowns; ++column) {
    int pivot = column;
    for (int row = column + 1; row < kUnknowns; ++row)
      if (std::abs(e.left[row][column]) > std::abs(e.left[pivot][column])) pivot = row;
    if (!(std::abs(e.left[pivot][column]) > kFlatShare)) return false;
    std::swap(e.left[pivot], e.left[column]);
    std::swap(e.right[pivot], e.right[column]);
    for (int row = 0; row < kUnknowns; ++row) {
      if (row == column) continue;
      const double factor = e.left[row][column] / e.left[column][column];
      for (int i = 0; i < kUnknowns; ++i) e.left[row][i] -= factor * e.left[column][i];
      for (int i = 0; i < kRows; ++i) e.right[row][i] -= factor * e.right[column][i];
    }
  }
  for (int row = 0; row < kUnknowns; ++row)
    for (int i = 0; i < kRows; ++i) e.right[row][i] /= e.left[row][row];
  return true;
}

/// Samples weigh by 1 / depth^2, so that errors count in pixels; the mean weight is 1.
Equations equationsOf(const Samples& samples, const Scale& scale) {
  Equations e;
  double weights = 0.0;
  for (const CameraSample& s : samples) {
    double q[kUnknowns] = {0.0, 0.0, 0.0, 1.0};
    for (std::size_t i = 0; i < 3; ++i) q[i] = (s.position[i] - scale.centre[i]) / scale.size;
    const double target[kRows] = {s.ndcX * s.depth, s.ndcY * s.depth, s.depth};
    const double weight = 1.0 / (s.depth * s.depth);
    weights += weight;
    for (int i = 0; i < kUnknowns; ++i) {
      for (int j = 0; j < kUnknowns; ++j) e.left[i][j] += weight * q[i] * q[j];
      for (int j = 0; j < kRows; ++j) e.right[i][j] += weight * q[i] * target[j];
    }
  }
  for (int i = 0; i < kUnknowns; ++i) {
    for (double& value : e.left[i]) value /= weights;
    for (double& value : e.right[i]) value /= weights;
  }
  return e;
}

/// Nothing for samples in one plane, or too few.
std::optional<Matrix4> leastSquares(const Samples& samples) {
  const Scale scale = scaleOf(samples);
  if (!(scale.size > 0.0)) return std::nullopt;  // NaN without any
  Equations e = equationsOf(samples, scale);
  if (!solve(e)) return std::nullopt;
  Matrix4 matrix{};
  constexpr std::size_t kMatrixRows[kRows] = {0, 1, 3};
  for (int row = 0; row < kRows; ++row) {
    double* out = &matrix[4 * kMatrixRows[row]];
    out[3] = e.right[3][row];
    for (int axis = 0; axis < 3; ++axis) {
      out[axis] = e.right[axis][row] / scale.size;
      out[3] -= out[axis] * scale.centre[std::size_t(axis)];
    }
  }
  return matrix;
}

double clipRow(const Matrix4& m, std::size_t row, const Vector3& p) {
  return m[4 * row] * p[0] + m[4 * row + 1] * p[1] + m[4 * row + 2] * p[2] + m[4 * row + 3];
}

/// Distances of samples from where a camera puts them; infinite where the depth is another one.
struct Distances {
  Matrix4 camera;
  int width, height;  // pixels

  double operator()(const CameraSample& s) const {
    const double w = clipRow(camera, 3, s.position);
    if (!(std::abs(w - s.depth) <= kDepthShare * s.depth)) return std::numeric_limits<double>::infinity();
    const double x = (clipRow(camera, 0, s.position) / w - s.ndcX) * 0.5 * width;
    const double y = (clipRow(camera, 1, s.position) / w - s.ndcY) * 0.5 * height;
    return std::hypot(x, y);
  }

  double median(const Samples& samples) const {
    std::vector<double> all;
    for (const CameraSample& sample : samples) all.push_back((*this)(sample));
    return middleValue(std::move(all));
  }
};

/// Every step-th sample from `first` on.
Samples every(std::size_t step, std::size_t first, const Samples& samples) {
  Samples chosen;
  for (std::size_t i = first; i < samples.size(); i += step) chosen.push_back(samples[i]);
  return chosen;
}

/// The camera of a few samples that is least off for half of all.
std::optional<Matrix4> leastMedianCamera(const Samples& samples, int width, int height) {
  const Samples judges = every(samples.size() / kJudges + 1, 0, samples);
  return leastMedian(samples, leastSquares, [&](const Matrix4& camera) {
    return Distances{camera, width, height}.median(judges);
  });
}

Samples nearSamples(const Samples& samples, const Distances& distances) {
  const double limit = std::max(kNearPx, kNearMedians * distances.median(samples));
  Samples near;
  for (const CameraSample& sample : samples)
    if (distances(sample) <= limit) near.push_back(sample);
  return near;
}

/// Each half of the samples must do: what stands out of a plane in a few pixels alone is no surface.
bool inOnePlane(const Samples& samples) {
  return !leastSquares(every(2, 0, samples)) || !leastSquares(every(2, 1, samples));
}

double rootMeanSquare(const Samples& samples, const Distances& distances) {
  double sum = 0.0;
  for (const CameraSample& sample : samples) sum += std::pow(distances(sample), 2.0);
  return std::sqrt(sum / double(samples.size()));
}

}  // namespace

FoundCamera fitCamera(const std::vector<CameraSample>& samples, int width, int height) {
  const FoundCamera flat{std::nullopt, "surfaces that lie in one plane"};
  if (samples.empty()) return {std::nullopt, "no surfaces"};
  std::optional<Matrix4> camera = leastMedianCamera(samples, width, height);
  Samples near = samples;
  for (int i = 0; i < kRefinements && camera; ++i) {
    near = nearSamples(samples, {*camera, width, height});
    camera = leastSquares(near);
  }
  if (!camera || inOnePlane(near)) return flat;
  const double px = rootMeanSquare(near, {*camera, width, height});
  if (2 * near.size() < samples.size() || !(px < kFitPx))
    return {std::nullopt,
            fmt::format("surfaces that the nearest perspective camera puts {:.1f} pixels off", px)};
  return {camera, {}};
}

}  // namespace quell::io
