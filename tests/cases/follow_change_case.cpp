#include "tests/cases/follow_change_case.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr double kStillShare = 0.5;  // of the tiles

// Largest magnitude of each pixel before the stage ran: what a blend's rounding errors are relative to.
ExactPlanes scalesOf(const Planes& blended, const Planes& newest) {
  ExactPlanes scales(blended.size(), 1);
  for (const Planes* planes : {&blended, &newest})
    for (int plane = 0; plane < planes->count; ++plane)
      forEachPixel(planes->size(), [&](int x, int y) {
        scales.at(0, x, y) = std::max(scales.at(0, x, y), std::abs(double(planes->at(plane, x, y))));
      });
  return scales;
}

// Bounds of luminance and of its square: a luminance is at most the largest component.
Planes squaredPlanes(Planes planes) {
  for (float& value : planes.values) value = std::max(value, value * value);
  return planes;
}

}  // namespace

FollowChangeCase::FollowChangeCase(const CaseOptions& options, int signals)
    : StageCase("follow_change", makeChangeSetup(options, signals)) {
  const Size size = options.size;
  inputs.weights = Planes({TileGrid(size).count() * signals, 1}, 1);
  Random random(options.seed + 10);
  for (float& weight : inputs.weights.values)
    weight = random.uniform() < kStillShare ? 0.0f : float(random.uniform(0.0, kChangeMostWeight));
  inputs.newestIrradiance = randomPlanes(size, 3 * signals, options.seed + 20, 0.0, 8.0);
  inputs.irradiance = randomPlanes(size, 3 * signals, options.seed + 21, 0.0, 8.0);
  inputs.moments = randomPlanes(size, QUELL_MOMENT_PLANES * signals, options.seed + 22, 0.0, 8.0);
  inputs.historyLength = randomHistoryLengths(size, signals, options.seed + 30);
  inputs.leastWeight = float(kChangeLeastWeight);
  inputs.momentsLeastWeight = float(kChangeMomentsLeastWeight);
}

void FollowChangeCase::upload() {
  m_harness.upload("changeWeights", inputs.weights);
  m_harness.upload("newestIrradiance", inputs.newestIrradiance);
  m_harness.upload("irradiance", inputs.irradiance);
  m_harness.upload("moments", inputs.moments);
  m_harness.upload("historyLength", inputs.historyLength);
}

FollowChangeOutputs FollowChangeCase::outputs() const {
  return {m_harness.download("irradiance"), m_harness.download("moments"),
          m_harness.download("historyLength")};
}

Comparison FollowChangeCase::compare() {
  Comparison comparison;
  const FollowChangeOutputs device = outputs();
  const FollowChangeExact exact = followChangeOracle(inputs);
  for (const char undecided : exact.undecided.values)
    if (undecided) comparison.exclude();
  const ExactPlanes light = scalesOf(inputs.irradiance, inputs.newestIrradiance);
  const ExactPlanes squares = scalesOf(inputs.moments, squaredPlanes(inputs.newestIrradiance));
  comparePixels(comparison, "irradiance", device.irradiance, exact.irradiance, &exact.undecided, &light);
  comparePixels(comparison, "moments", device.moments, exact.moments, &exact.undecided, &squares);
  comparePixels(comparison, "historyLength", device.historyLength, exact.historyLength, &exact.undecided);
  return comparison;
}

}  // namespace quell::tests
