#include "tests/cases/tone_map_case.hpp"

#include <cmath>

#include "tests/oracle/tone_map_oracle.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr double kBrightest = 1.5;      // some values are clamped
constexpr double kDarkestLog2 = -40.0;  // others far below the smallest step of a display

StageSetup makeToneMapSetup(const CaseOptions& options, bool isLast) {
  StageSetup setup = makeSetup(options);
  setup.output.display = makeView(options.layout, options.size);
  setup.settings.set("taa", isLast ? "off" : "on");
  return setup;
}

}  // namespace

ToneMapCase::ToneMapCase(const CaseOptions& options, bool isLast)
    : StageCase("tone_map", makeToneMapSetup(options, isLast)),
      linear(randomPlanes(options.size, 3, options.seed, -0.1, kBrightest)),
      m_isLast(isLast),
      m_layout(options.layout) {
  Random random(options.seed + 1);
  for (std::size_t i = 0; i < linear.values.size(); i += 3)
    linear.values[i] = float(std::exp2(random.uniform(kDarkestLog2, 1.0)));
}

void ToneMapCase::upload() { m_harness.upload("linear", linear); }

Comparison ToneMapCase::compare() {
  Comparison comparison;
  const ExactPlanes exact = toneMapOracle(linear);
  if (m_isLast) {
    compareOutput(comparison, m_harness, &Output::display, exact);
  } else {
    comparePixels(comparison, "encoded", encoded(), exact);
  }
  return comparison;
}

double ToneMapCase::tolerance() const {
  return kToneMapTolerance + (m_isLast ? storageError(m_layout) : 0.0);
}

}  // namespace quell::tests
