#include "tests/cases/variance_case.hpp"

#include <algorithm>

#include "kernels/common/guides.h"
#include "tests/cases/firefly_weights_case.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr int kTemporalFrames = 5;  // not the default

StageSetup makeVarianceSetup(const CaseOptions& options, int signals, VarianceOf of) {
  StageSetup setup = makeSetup(options);
  setFilterMethod(setup, of == VarianceOf::Mean ? "quell" : "svgf", {signals, false});
  if (of == VarianceOf::Samples) {
    setup.settings.set("fireflyRatio", 0.0);
    setup.settings.set("keepLight", 0.0);
  }
  setup.settings.set("temporalVarianceFrames", kTemporalFrames);
  return setup;
}

// Variances of all sizes, 0 and, as rounding may have it, less than 0 included.
Planes randomMoments(Size size, int signals, unsigned seed) {
  Random random(seed);
  Planes moments(size, QUELL_MOMENT_PLANES * signals);
  for (int signal = 0; signal < signals; ++signal) {
    forEachPixel(size, [&](int x, int y) {
      const double mean = random.uniform(0.0, 4.0);
      const double variance = random.uniform(-0.1, 1.0) * random.uniform(0.0, 8.0);
      moments.at(QUELL_MOMENT_PLANES * signal + QUELL_MOMENT_FIRST, x, y) = float(mean);
      moments.at(QUELL_MOMENT_PLANES * signal + QUELL_MOMENT_SECOND, x, y) = float(mean * mean + variance);
    });
  }
  return moments;
}

}  // namespace

VarianceCase::VarianceCase(const CaseOptions& options, int signals, VarianceOf of)
    : StageCase("variance", makeVarianceSetup(options, signals, of)) {
  const Settings& settings = m_harness.configuration().settings;
  inputs.guides = randomGuides({signals, false}, options);
  inputs.moments = randomMoments(options.size, signals, options.seed + 10);
  inputs.historyLength = Planes(options.size, signals);
  if (of == VarianceOf::Mean) {
    inputs.irradiance = randomPlanes(options.size, 3 * signals, options.seed + 30, 0.0, 8.0);
    addFireflies(inputs.irradiance, options.seed + 31);
    inputs.fireflyRatio = settings.get("fireflyRatio");
    inputs.momentsLeastWeight = settings.get("momentsLeastWeight");
  }
  Random random(options.seed + 20);
  for (float& length : inputs.historyLength.values)
    length =
        float(random.integer(0, random.uniform() < 0.1 ? QUELL_MAX_HISTORY_LENGTH : 2 * kTemporalFrames));
  inputs.stops = edgeStopsOf(settings);
  inputs.temporalFrames = kTemporalFrames;
  inputs.ofMean = of == VarianceOf::Mean;
}

void VarianceCase::upload() {
  uploadGuides(m_harness, inputs.guides);
  m_harness.upload("moments", inputs.moments);
  m_harness.upload("historyLength", inputs.historyLength);
  if (inputs.irradiance.count > 0) m_harness.upload("irradiance", inputs.irradiance);
}

Comparison VarianceCase::compare() {
  Comparison comparison(leftOut());
  const Planes device = variance();
  const VarianceExact exact = varianceOracle(inputs);
  for (int signal = 0; signal < device.count; ++signal) {
    forEachPixel(size(), [&](int x, int y) {
      comparison.include("variance", signal, x, y, device.at(signal, x, y), exact.variance.at(signal, x, y),
                         std::max(lightUnit() * lightUnit(), exact.magnitude.at(signal, x, y)));
    });
  }
  if (inputs.irradiance.count > 0) {
    comparePixels(comparison, "stop luminance", m_harness.download("stopLuminance"), exact.stopLuminance,
                  nullptr, nullptr, lightUnit());
    compareTapWeights(comparison, m_harness.download("tapWeights"), exact.tapWeights);
  }
  return comparison;
}

}  // namespace quell::tests
