#include "tests/cases/light_gain_case.hpp"

#include <limits>

#include "tests/cases/filter_inputs.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr float kBehindRecords = 1e20f;  // counts for nothing
constexpr double kSummedPixels = QUELL_TILE * QUELL_TILE / QUELL_LIGHT_ROW_STEP;

StageSetup makeLightGainSetup(const CaseOptions& options, int signals) {
  StageSetup setup = makeSetup(options);
  setFilterMethod(setup, "quell", {signals, false});
  return setup;
}

}  // namespace

LightGainCase::LightGainCase(const CaseOptions& options, int signals)
    : StageCase("light_gain", makeLightGainSetup(options, signals)) {
  inputs.size = options.size;
  inputs.signals = signals;
  inputs.sums = Planes({QUELL_LIGHT_NUMBERS(tileCount()), 1}, 1, kBehindRecords);
  Random random(options.seed + 10);
  for (int tile = 0; tile < tileCount(); ++tile) {
    const double luminance = random.uniform() < 0.1 ? 0.0 : random.uniform(0.1, 4.0);
    setTile(tile, kSummedPixels * luminance * random.uniform(-0.2, 0.6),
            kSummedPixels * luminance * luminance);
  }
}

void LightGainCase::setTile(int tile, double lost, double squares) {
  float* record = &inputs.sums.values[std::size_t(tile) * QUELL_LIGHT_RECORD];
  record[QUELL_LIGHT_LOST] = float(lost);
  record[QUELL_LIGHT_SQUARES] = float(squares);
}

void LightGainCase::upload() { m_harness.upload("lightSums", inputs.sums); }

Comparison LightGainCase::compare() {
  Comparison comparison;
  const Planes device = gains();
  const LightGainExact exact = lightGainOracle(inputs);
  if (device.values.size() != exact.gains.values.size())
    comparison.include("number of gains", 0, 0, 0, std::numeric_limits<double>::infinity(), 0.0);
  for (int i = 0; i < exact.gains.width; ++i) {
    const double magnitude = exact.magnitudes.at(0, i, 0);
    comparison.include("gain", 0, i, 0, device.at(0, i, 0), exact.gains.at(0, i, 0),
                       magnitude > 0.0 ? magnitude : 1.0);
  }
  return comparison;
}

std::vector<LightInput> LightGainCase::light() {
  std::vector<LightInput> all;
  for (int tile = 0; tile < tileCount(); ++tile) {
    float* record = &inputs.sums.values[std::size_t(tile) * QUELL_LIGHT_RECORD];
    all.push_back({&record[QUELL_LIGHT_LOST], 1, 1});
    all.push_back({&record[QUELL_LIGHT_SQUARES], 1, 2});
  }
  return all;
}

}  // namespace quell::tests
