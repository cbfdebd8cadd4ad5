#include "tests/cases/soft_history_case.hpp"

#include <cmath>

#include "kernels/common/guides.h"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr int kSignals = 2;
constexpr double kDepth = 5.0;        // scene units
constexpr double kFootprint = 0.005;  // per clip.w: distances below are of some footprints
constexpr double kScatter = 0.08;     // of positions, scene units
constexpr double kMostLight = 8.0;

StageSetup makeSoftHistorySetup(const CaseOptions& options, int signal, bool motion) {
  StageSetup setup = makeEdagiSetup(options);
  setup.occurrence = signal;
  setup.settings.set("meanFirst", signal == 0 ? "on" : "off");
  if (motion) setup.frame.motion = makeView(packed(2), setup.size);
  return setup;
}

ReprojectionParams alongZ() {
  ReprojectionParams params{};
  params.clipW = {0.0f, 0.0f, -1.0f, 0.0f};
  params.cameraMotion = {0.03f, -0.02f, 0.05f, 0.0f};
  params.footprint = float(kFootprint);
  return params;
}

// Of one surface, moved by `shift`.
Planes scatteredPositions(Size size, unsigned seed, const QuellFloat4& shift) {
  Planes positions = randomPlanes(size, 3, seed, -kScatter, kScatter);
  forEachPixel(size, [&](int x, int y) {
    positions.at(0, x, y) -= shift.x;
    positions.at(1, x, y) -= shift.y;
    positions.at(2, x, y) -= shift.z + float(kDepth);
  });
  return positions;
}

// Three planes at `first` of a buffer of `count`; in the others something else.
Planes amid(const Planes& planes, int first, int count) {
  Planes all = randomPlanes(planes.size(), count, 99, 50.0, 60.0);
  for (int plane = 0; plane < planes.count; ++plane)
    forEachPixel(planes.size(), [&](int x, int y) { all.at(first + plane, x, y) = planes.at(plane, x, y); });
  return all;
}

}  // namespace

SoftHistoryCase::SoftHistoryCase(const CaseOptions& options, int signal, bool motion)
    : StageCase("soft_history", makeSoftHistorySetup(options, signal, motion)), m_signal(signal) {
  const Size size = options.size;
  const RandomMotion path = randomMotion(size, options.seed);
  m_guides = randomGuides({kSignals, false}, options).guides;
  m_reprojection = alongZ();
  inputs.reprojection = m_reprojection;
  inputs.irradiance = randomPlanes(size, 3, options.seed + 1, 0.0, kMostLight);
  inputs.historyPrev = randomPlanes(size, 3, options.seed + 2, 0.0, kMostLight);
  inputs.weights = planesOf(m_guides, QUELL_GUIDE_WEIGHT + signal, 1);
  inputs.positions = scatteredPositions(size, options.seed + 3, {});
  inputs.positionsPrev = scatteredPositions(size, options.seed + 4, m_reprojection.cameraMotion);
  inputs.pixelPrev = path.pixelPrev;
  inputs.tapMask = path.reprojectionMask;
  inputs.historyLength = randomPlanes(size, 1, options.seed + 5, 0.0, 20.0);
  for (float& length : inputs.historyLength.values) length = std::floor(length);
  const Settings& settings = m_harness.configuration().settings;
  inputs.hysteresis = settings.get("hysteresis");
  inputs.nearFootprints = settings.get("nearFootprints");
  inputs.farFootprints = settings.get("farFootprints");
  inputs.clampSigma = settings.get("clampSigma");
  inputs.meanFirst = settings.get("meanFirst") != 0.0;
  inputs.trustsMotion = motion && signal == 0;
}

void SoftHistoryCase::upload() {
  const bool isVirtual = m_signal == 1;
  const int positionPlanes = isVirtual ? 3 : QUELL_GUIDE_PLANES_OF(kSignals);
  m_harness.upload("irradiance", amid(inputs.irradiance, 3 * m_signal, 3 * kSignals));
  m_harness.upload("historyPrev", amid(inputs.historyPrev, 3 * m_signal, 3 * kSignals));
  m_harness.upload("guides", m_guides);
  m_harness.upload("positions", amid(inputs.positions, QUELL_GUIDE_POSITION, positionPlanes));
  m_harness.upload("positionsPrev", amid(inputs.positionsPrev, QUELL_GUIDE_POSITION, positionPlanes));
  m_harness.upload("pixelPrev", inputs.pixelPrev);
  m_harness.upload("tapMask", isVirtual ? inputs.tapMask : amid(inputs.tapMask, m_signal, kSignals));
  m_harness.upload("historyLength", amid(inputs.historyLength, m_signal, kSignals));
}

Comparison SoftHistoryCase::compare() {
  Comparison comparison(leftOut());
  const SoftHistoryExact exact = softHistoryOracle(inputs);
  ExactPlanes scales(size(), 1, kMostLight * lightUnit());
  comparePixels(comparison, "blended", blended(), exact.blended, leftOut(), &scales, lightUnit());
  comparePixels(comparison, "confidence", confidence(), exact.confidence, leftOut());
  return comparison;
}

}  // namespace quell::tests
