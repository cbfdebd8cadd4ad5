#include "tests/cases/follow_change_case.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr double kStillShare = 0.5;  // of the tiles

// Largest magnitude of each pixel in one of the planes: what a blend's rounding errors are relative to.
void include(ExactPlanes& scales, int plane, const Planes& values, int first, int count, int power = 1) {
  for (int source = first; source < first + count; ++source)
    forEachPixel(values.size(), [&](int x, int y) {
      double& scale = scales.at(plane, x, y);
      scale = std::max(scale, std::pow(std::abs(double(values.at(source, x, y))), power));
    });
}

// Of each moment. A luminance is at most the largest component.
ExactPlanes scalesOfMoments(const FollowChangeInputs& inputs) {
  ExactPlanes scales(inputs.moments.size(), inputs.moments.count);
  for (int plane = 0; plane < scales.count; ++plane) {
    const int signal = plane / QUELL_MOMENT_PLANES;
    include(scales, plane, inputs.moments, plane, 1);
    include(scales, plane, inputs.newestIrradiance, 3 * signal, 3,
            plane % QUELL_MOMENT_PLANES == QUELL_MOMENT_FIRST ? 1 : 2);
  }
  return scales;
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

std::vector<LightInput> FollowChangeCase::light() {
  std::vector<LightInput> all = momentsOf(inputs.moments);
  all.push_back(lightOf(inputs.newestIrradiance));
  all.push_back(lightOf(inputs.irradiance));
  return all;
}

FollowChangeOutputs FollowChangeCase::outputs() const {
  return {m_harness.download("irradiance"), m_harness.download("moments"),
          m_harness.download("historyLength")};
}

Comparison FollowChangeCase::compare() {
  Comparison comparison(leftOut());
  const FollowChangeOutputs device = outputs();
  const FollowChangeExact exact = followChangeOracle(inputs);
  comparison.exclude(exact.undecided);
  ExactPlanes brightest(size(), 1);
  for (const Planes* planes : {&inputs.irradiance, &inputs.newestIrradiance})
    include(brightest, 0, *planes, 0, planes->count);
  const ExactPlanes moments = scalesOfMoments(inputs);
  comparePixels(comparison, "irradiance", device.irradiance, exact.irradiance, &exact.undecided, &brightest,
                lightUnit());
  compareMoments(comparison, device.moments, exact.moments, &exact.undecided, &moments);
  comparePixels(comparison, "historyLength", device.historyLength, exact.historyLength, &exact.undecided);
  return comparison;
}

}  // namespace quell::tests
