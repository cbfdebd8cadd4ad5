#include "tests/oracle/soft_history_oracle.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "kernels/common/guides.h"
#include "tests/oracle/bilinear_oracle.hpp"
#include "tests/oracle/surface_oracle.hpp"

namespace quell::tests {
namespace {

using Eigen::Array3d;
using Eigen::Vector3d;

Vector3d vectorAt(const Planes& planes, int x, int y) {
  return {planes.at(0, x, y), planes.at(1, x, y), planes.at(2, x, y)};
}

// Eq. (11), falling.
double confidenceAt(double distance, double nearest, double farthest) {
  const double t = std::clamp((distance - nearest) / (farthest - nearest), 0.0, 1.0);
  return 1.0 - t * t * (3.0 - 2.0 * t);
}

struct History {
  Vector3d irradiance = Vector3d::Zero();
  double confidence = 0.0;
};

History gatherHistory(const SoftHistoryInputs& inputs, int x, int y) {
  const Vector3d expected = vectorAt(inputs.positions, x, y);
  const double depth =
      std::max(linearPart(inputs.reprojection.clipW).dot(expected) + inputs.reprojection.clipW.w, 0.0);
  const double footprint = inputs.reprojection.footprint * depth;
  const int mask = int(inputs.tapMask.at(0, x, y));
  History history;
  double accepted = 0.0, trusted = 0.0;
  for (const Tap& tap :
       bilinearTaps(inputs.weights.size(), inputs.pixelPrev.at(0, x, y), inputs.pixelPrev.at(1, x, y))) {
    if ((mask & QUELL_TAP_ACCEPTED(tap.index)) == 0) continue;
    const Vector3d found =
        vectorAt(inputs.positionsPrev, tap.x, tap.y) + linearPart(inputs.reprojection.cameraMotion);
    const double distance = inputs.trustsMotion ? 0.0 : (found - expected).norm();
    const double weight = tap.weight * confidenceAt(distance, inputs.nearFootprints * footprint,
                                                    inputs.farFootprints * footprint);
    history.irradiance += weight * vectorAt(inputs.historyPrev, tap.x, tap.y);
    accepted += tap.weight;
    trusted += weight;
  }
  if (trusted <= 0.0) return {};
  return {history.irradiance / trusted, trusted / accepted};
}

Vector3d clampToNewest(const SoftHistoryInputs& inputs, const Vector3d& history, int x, int y) {
  const Size size = inputs.weights.size();
  Array3d sum = Array3d::Zero(), squares = Array3d::Zero();
  double count = 0.0;
  for (int row = std::max(0, y - 1); row <= std::min(size.height - 1, y + 1); ++row) {
    for (int column = std::max(0, x - 1); column <= std::min(size.width - 1, x + 1); ++column) {
      if (inputs.weights.at(0, column, row) == 0.0f) continue;
      const Array3d value = vectorAt(inputs.irradiance, column, row).array();
      sum += value;
      squares += value.square();
      count += 1.0;
    }
  }
  if (count == 0.0) return history;
  const Array3d mean = sum / count;
  const Array3d reach = inputs.clampSigma * (squares / count - mean.square()).max(0.0).sqrt();
  return history.array().max(mean - reach).min(mean + reach).matrix();
}

}  // namespace

SoftHistoryExact softHistoryOracle(const SoftHistoryInputs& inputs) {
  const Size size = inputs.weights.size();
  SoftHistoryExact exact{ExactPlanes(size, 3), ExactPlanes(size, 1)};
  forEachPixel(size, [&](int x, int y) {
    const History history = gatherHistory(inputs, x, y);
    const Vector3d old =
        inputs.clampSigma > 0.0 ? clampToNewest(inputs, history.irradiance, x, y) : history.irradiance;
    const double frames = std::max(1.0, double(inputs.historyLength.at(0, x, y)));
    const double kept =
        history.confidence * std::min(inputs.hysteresis, inputs.meanFirst ? 1.0 - 1.0 / frames : 1.0);
    const Vector3d blended = (1.0 - kept) * vectorAt(inputs.irradiance, x, y) + kept * old;
    for (int c = 0; c < 3; ++c) exact.blended.at(c, x, y) = blended[c];
    exact.confidence.at(0, x, y) = history.confidence;
  });
  return exact;
}

}  // namespace quell::tests
