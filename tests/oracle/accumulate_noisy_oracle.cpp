#include "tests/oracle/accumulate_noisy_oracle.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "kernels/common/motion_params.h"
#include "tests/oracle/bilinear_oracle.hpp"

namespace quell::tests {
namespace {

constexpr double kRounding = kSurfaceRounding;
// Error of a reprojected position in float, pixels: 480 pixels times the rounding of a 4-term dot product.
constexpr double kPixelRounding = 1e-3;
// Error of a history length up to 255 that was interpolated in float.
constexpr double kLengthRounding = 2e-4;
// Error of a length n that follows from a turn, over n^2: normals rounded to 1e-7 that are 0.08 / n apart.
constexpr double kTurnRounding = 1e-5;

struct Place {
  Vector3d pixel = Vector3d::Zero();  // x, y; 0 if not inside
  bool inside = false;
};

bool near(double value, double threshold, double rounding) { return std::abs(value - threshold) <= rounding; }

Vector3d planeVector(const Planes& planes, int first, int x, int y) {
  return {planes.at(first, x, y), planes.at(first + 1, x, y), planes.at(first + 2, x, y)};
}

// The oracle for one frame; `undecided` collects doubts about the pixel at hand.
class PixelOracle {
 public:
  PixelOracle(const AccumulateNoisyInputs& inputs, int x, int y)
      : m_inputs(inputs), m_params(inputs.reprojection), m_x(x), m_y(y) {}

  bool undecided = false;

  Surface surface() { return filteredSurfaceAt(m_inputs, m_x, m_y, undecided); }

  Place previous(const Surface& s) {
    if (m_params.historyValid == 0) return {};
    return m_inputs.motion.empty() ? reproject(s) : followMotion();
  }

  bool sameHistory(const Surface& s, const Tap& tap) {
    if (!m_inputs.objectId.empty() &&
        m_inputs.objectIdsPrev.at(0, tap.x, tap.y) != m_inputs.objectId.at(m_x, m_y, 0))
      return false;
    if (!sameNormal(s, tap)) return false;
    return m_inputs.motion.empty() ? nearPosition(s, tap) : nearDepth(s, tap);
  }

  // Frames that history may reach back along a surface that turns; `normalPrev` is the mean over the taps of the
  // surface.
  double longestHistory(const Surface& s, const Vector3d& place, const Vector3d& normalPrev) {
    if (m_inputs.motion.empty()) return QUELL_MAX_HISTORY_LENGTH;
    const Place atRest = reproject(s);
    const double off = (atRest.pixel - place).cwiseAbs().maxCoeff();
    if (atRest.inside) doubt(off, QUELL_MOVING_PX, 0.5 / QUELL_SUBPIXEL_STEPS + kPixelRounding);
    if (atRest.inside && off <= QUELL_MOVING_PX) return QUELL_MAX_HISTORY_LENGTH;
    const double step = std::max((normalPrev - s.normal).squaredNorm(), double(QUELL_LEAST_TURN_SQUARED));
    return QUELL_TURN_SHARE * std::sqrt(m_params.normalLimitSquared / step);
  }

  void doubt(double value, double threshold, double rounding) {
    undecided = undecided || near(value, threshold, rounding);
  }

 private:
  // Background is a point at infinity. The pixel's centre moved as what was sampled in the pixel.
  Place reproject(const Surface& s) {
    const Vector3d target = s.valid ? s.position : viewRay(m_params, m_x, m_y);
    const double constant = s.valid ? 1.0 : 0.0;
    const auto apply = [&](const QuellFloat4& row) { return linearPart(row).dot(target) + constant * row.w; };
    const double w = apply(m_params.clipW), wPrev = apply(m_params.clipWPrev);
    const double motionX = apply(m_params.pixelXPrev) / wPrev - apply(m_params.pixelX) / w;
    const double motionY = apply(m_params.pixelYPrev) / wPrev - apply(m_params.pixelY) / w;
    doubt(w, 0.0, kRounding * target.norm());
    doubt(wPrev, 0.0, kRounding * target.norm());
    return w > 0.0 && wPrev > 0.0 ? placeAt(m_x + motionX, m_y + motionY) : Place();
  }

  Place followMotion() {
    return placeAt(m_x + double(m_inputs.motion.at(m_x, m_y, 0)),
                   m_y + double(m_inputs.motion.at(m_x, m_y, 1)));
  }

  Place placeAt(double x, double y) {
    const double width = m_inputs.irradiancePrev.width, height = m_inputs.irradiancePrev.height;
    // The device looks after it has rounded to a step.
    constexpr double kRoundedStep = 0.5 / QUELL_SUBPIXEL_STEPS + kPixelRounding;
    doubt(x, -1.0, kRoundedStep);
    doubt(y, -1.0, kRoundedStep);
    doubt(x, width, kRoundedStep);
    doubt(y, height, kRoundedStep);
    if (!(x > -1.0 && x < width && y > -1.0 && y < height)) return {};
    return {{x, y, 0.0}, true};
  }

  bool sameNormal(const Surface& s, const Tap& tap) {
    const Vector3d normalPrev = planeVector(m_inputs.guidesPrev, QUELL_GUIDE_NORMAL, tap.x, tap.y);
    const double distance = (normalPrev - s.normal).squaredNorm();
    doubt(distance, m_params.normalLimitSquared, kRounding);
    return distance <= m_params.normalLimitSquared;
  }

  // Of the frame before, relative to this frame's camera.
  Vector3d positionPrev(const Tap& tap) const {
    return planeVector(m_inputs.guidesPrev, QUELL_GUIDE_POSITION, tap.x, tap.y) +
           linearPart(m_params.cameraMotion);
  }

  bool nearPosition(const Surface& s, const Tap& tap) {
    const Vector3d position = positionPrev(tap);
    const double depth = linearPart(m_params.clipW).dot(s.position) + m_params.clipW.w;
    const double limit = m_params.positionLimit + m_params.positionLimitFootprint * std::max(depth, 0.0);
    const double distance = (position - s.position).norm();
    doubt(distance, limit, kRounding * (position.norm() + s.position.norm() + limit));
    return distance <= limit;
  }

  bool nearDepth(const Surface& s, const Tap& tap) {
    const Vector3d axis = linearPart(m_params.clipWPrev);
    const double depth = axis.dot(s.position) + m_params.clipWPrev.w;
    const double step = std::abs(axis.dot(positionPrev(tap) - s.position));
    doubt(step, QUELL_DEPTH_STEP_LIMIT * depth, kRounding * (step + s.position.norm()));
    return step <= QUELL_DEPTH_STEP_LIMIT * depth;
  }

  const AccumulateNoisyInputs& m_inputs;
  const ReprojectionParams& m_params;
  int m_x, m_y;
};

struct History {
  Vector3d irradiance = Vector3d::Zero();
  double moments[QUELL_MOMENT_PLANES] = {};
  double length = 0.0;           // whole
  double effectiveLength = 0.0;  // the same before it was rounded down where the surface turns
  double weight = 0.0;
  int mask = 0;
};

History gatherHistory(const AccumulateNoisyInputs& inputs, PixelOracle& oracle, const Surface& surface,
                      int signal, double x, double y, int mostFrames) {
  History history;
  history.mask = QUELL_PREV_IN_FRAME;
  if (!surface.valid) return history;
  Vector3d normal = Vector3d::Zero();
  double normalWeight = 0.0;
  for (const Tap& tap : bilinearTaps(inputs.irradiancePrev.size(), x, y)) {
    if (!tap.inFrame || !oracle.sameHistory(surface, tap)) continue;
    normal += tap.weight * planeVector(inputs.guidesPrev, QUELL_GUIDE_NORMAL, tap.x, tap.y);
    normalWeight += tap.weight;
    const double weight = tap.weight * inputs.guidesPrev.at(QUELL_GUIDE_WEIGHT + signal, tap.x, tap.y);
    if (!(weight > 0.0)) continue;
    history.irradiance += weight * planeVector(inputs.irradiancePrev, 3 * signal, tap.x, tap.y);
    for (int i = 0; i < QUELL_MOMENT_PLANES && inputs.momentsLeastWeight > 0.0; ++i)
      history.moments[i] += weight * inputs.momentsPrev.at(QUELL_MOMENT_PLANES * signal + i, tap.x, tap.y);
    history.length += weight * inputs.historyLengthPrev.at(signal, tap.x, tap.y);
    history.weight += weight;
    history.mask |= QUELL_TAP_ACCEPTED(tap.index);
  }
  if (history.weight == 0.0) return history;
  history.irradiance /= history.weight;
  for (double& moment : history.moments) moment /= history.weight;
  history.length /= history.weight;
  oracle.doubt(history.length + 0.5, std::round(history.length + 0.5), kLengthRounding);
  const double longest = oracle.longestHistory(surface, {x, y, 0.0}, normal / normalWeight);
  history.effectiveLength = std::min(std::floor(history.length + 0.5), mostFrames - 1.0);
  const double turnRounding = kLengthRounding + kTurnRounding * longest * longest;
  if (longest < history.effectiveLength + turnRounding) {
    oracle.doubt(longest, std::round(longest), turnRounding);
    history.effectiveLength = std::min(history.effectiveLength, longest);
  }
  history.length = std::floor(history.effectiveLength);
  return history;
}

// Weight of the newest of the samples behind a mean.
double newestWeight(bool present, const History& history, double leastWeight) {
  if (!present) return 0.0;
  return history.weight > 0.0 ? std::max(1.0 / (history.effectiveLength + 1.0), leastWeight) : 1.0;
}

// Rec. 709.
double luminance(const Vector3d& rgb) { return Vector3d(0.2126, 0.7152, 0.0722).dot(rgb); }

// A pixel that is not filtered needs none.
History withoutSamples(const History& history) {
  History none;
  none.mask = history.mask;
  return none;
}

void storeSignal(AccumulateNoisyOutputs<double>& outputs, int signal, int x, int y, const Vector3d& sample,
                 bool present, const History& history, const AccumulateNoisyInputs& inputs) {
  const double blend = newestWeight(present, history, inputs.leastWeight);
  const Vector3d blended = blend * sample + (1.0 - blend) * history.irradiance;
  for (int c = 0; c < 3; ++c) {
    outputs.irradiance.at(3 * signal + c, x, y) = blended[c];
    outputs.newestIrradiance.at(3 * signal + c, x, y) = present ? sample[c] : -1.0;
  }
  if (present && history.weight > 0.0) {
    const Vector3d step = sample - history.irradiance;
    const double rounding = QUELL_LEAST_INNOVATION * luminance(sample);
    const auto store = [&](int plane, double difference) {
      outputs.innovation.at(QUELL_INNOVATION_PLANES * signal + plane, x, y) =
          std::abs(difference) > rounding ? difference : 0.0;
    };
    store(QUELL_INNOVATION_LUMINANCE, luminance(step));
    store(QUELL_INNOVATION_CHROMINANCE, step[0] - step[2]);
  }
  outputs.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y) = present || history.weight > 0.0 ? 1.0 : 0.0;
  outputs.historyLength.at(signal, x, y) = history.length + (present ? 1 : 0);
  outputs.reprojectionMask.at(signal, x, y) = history.mask;
  if (inputs.momentsLeastWeight == 0.0) return;
  const double momentsBlend = newestWeight(present, history, inputs.momentsLeastWeight);
  for (int i = 0; i < QUELL_MOMENT_PLANES; ++i)
    outputs.moments.at(QUELL_MOMENT_PLANES * signal + i, x, y) =
        momentsBlend * std::pow(luminance(sample), i + 1) + (1.0 - momentsBlend) * history.moments[i];
}

void storeSurface(AccumulateNoisyOutputs<double>& outputs, int x, int y, const Surface& surface,
                  const AccumulateNoisyInputs& inputs) {
  for (int axis = 0; axis < 3; ++axis) {
    outputs.guides.at(QUELL_GUIDE_POSITION + axis, x, y) = surface.position[axis];
    outputs.guides.at(QUELL_GUIDE_NORMAL + axis, x, y) = surface.normal[axis];
  }
  outputs.viewDepth.at(0, x, y) = viewDepthOf(inputs, surface);
  if (!inputs.roughness.empty()) outputs.roughness.at(0, x, y) = roughnessAt(inputs, x, y);
  if (!inputs.objectId.empty()) outputs.objectIds.at(0, x, y) = inputs.objectId.at(x, y, 0);
}

// Where no signal has accepted a tap, all say so.
void markRejected(ExactPlanes& mask, int x, int y) {
  for (int signal = 0; signal < mask.count; ++signal)
    if (mask.at(signal, x, y) != QUELL_PREV_IN_FRAME) return;
  for (int signal = 0; signal < mask.count; ++signal) mask.at(signal, x, y) += QUELL_HISTORY_REJECTED;
}

AccumulateNoisyExact emptyOutputs(Size size, int signals) {
  return {{ExactPlanes(size, 3 * signals), ExactPlanes(size, signals),
           ExactPlanes(size, QUELL_GUIDE_WEIGHT + signals), ExactPlanes(size, 2), ExactPlanes(size, signals),
           ExactPlanes(size, QUELL_MOMENT_PLANES * signals), ExactPlanes(size, 1), ExactPlanes(size, 1),
           ExactPlanes(size, 1), ExactPlanes(size, 3 * signals),
           ExactPlanes(size, QUELL_INNOVATION_PLANES * signals)},
          BasicPlanes<char>(size, 1)};
}

}  // namespace

AccumulateNoisyExact accumulateNoisyOracle(const AccumulateNoisyInputs& inputs, const Planes& pixelPrev) {
  const Size size = inputs.irradiancePrev.size();
  const int signals = inputs.material.signals();
  AccumulateNoisyExact exact = emptyOutputs(size, signals);
  forEachPixel(size, [&](int x, int y) {
    PixelOracle oracle(inputs, x, y);
    const Surface surface = oracle.surface();
    const Place place = oracle.previous(surface);
    for (int signal = 0; signal < signals; ++signal) {
      const Material material = materialAt(inputs.material, x, y, signal);
      const double xPrev = pixelPrev.at(0, x, y), yPrev = pixelPrev.at(1, x, y);
      const int mostFrames = xPrev == x && yPrev == y ? inputs.mostFramesStill : inputs.mostFrames;
      History history =
          place.inside ? gatherHistory(inputs, oracle, surface, signal, xPrev, yPrev, mostFrames) : History();
      const bool passes = material.passesThrough(history.weight > 0.0);
      if (passes) history = withoutSamples(history);
      const bool present = material.finite && surface.valid && !passes;
      storeSignal(exact.outputs, signal, x, y, material.irradiance(), present, history, inputs);
      oracle.undecided = oracle.undecided || material.undecided;
    }
    storeSurface(exact.outputs, x, y, surface, inputs);
    if (place.inside && surface.valid) markRejected(exact.outputs.reprojectionMask, x, y);
    exact.outputs.pixelPrev.at(0, x, y) = place.pixel.x();
    exact.outputs.pixelPrev.at(1, x, y) = place.pixel.y();
    exact.undecided.at(0, x, y) = oracle.undecided;
  });
  return exact;
}

}  // namespace quell::tests
