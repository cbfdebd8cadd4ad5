#include "tests/cases/change_weight_case.hpp"

#include <cmath>
#include <limits>

#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

double randomCount(Random& random) {
  const double kind = random.uniform();
  const int all = QUELL_TILE * QUELL_TILE;
  return kind < 0.2 ? 0.0 : kind < 0.4 ? random.integer(1, 8) : random.integer(all / 2, 2 * all);
}

}  // namespace

ChangeWeightCase::ChangeWeightCase(const CaseOptions& options, int signals, ChangeSettings settings)
    : StageCase("change_weight", makeChangeSetup(options, signals, settings)) {
  const Settings& used = m_harness.configuration().settings;
  inputs.size = options.size;
  inputs.signals = signals;
  inputs.threshold = used.get("changeThreshold");
  inputs.recentChangeThreshold = used.get("recentChangeThreshold");
  inputs.gain = used.get("changeGain");
  inputs.mostWeight = used.get("mostWeight");
  inputs.sums = Planes({tileCount() * QUELL_CHANGE_RECORD, 1}, 1);
  inputs.recentChangePrev = Planes({tileCount(), 1}, 1);
  Random random(options.seed + 10);
  for (float& recentChange : inputs.recentChangePrev.values) recentChange = float(random.uniform(0.0, 3.0));
  for (int tile = 0; tile < tileCount(); ++tile) {
    const double spread = random.uniform(0.1, 4.0);
    const auto differences = [&](double share) {
      const double mean = std::sqrt(spread) * std::pow(random.uniform(-1.0, 1.0), 5.0);
      return Differences{share * mean, share * share * spread};
    };
    const Differences luminance = differences(1.0);
    // From the chrominance of grey light to colours.
    setTile(tile, randomCount(random), luminance, differences(std::pow(10.0, random.uniform(-4.0, 0.5))));
    if (random.uniform() < 0.1)
      inputs.sums.values[std::size_t(tile) * QUELL_CHANGE_RECORD + QUELL_CHANGE_AGREEMENT] =
          float(random.uniform(0.0, 30.0));
  }
  useFrame(1);
}

void ChangeWeightCase::useFrame(std::uint32_t frameIndex) {
  m_frameIndex = frameIndex;
  inputs.restarted = frameIndex == 0;
}

void ChangeWeightCase::setTile(int tile, double count, Differences luminance, Differences chrominance) {
  float* record = &inputs.sums.values[std::size_t(tile) * QUELL_CHANGE_RECORD];
  record[QUELL_CHANGE_COUNT] = float(count);
  const auto set = [&](int plane, Differences d) {
    record[QUELL_CHANGE_SUM(plane)] = float(count * d.mean);
    record[QUELL_CHANGE_SQUARES(plane)] = float(count * (d.mean * d.mean + d.spread));
  };
  set(QUELL_INNOVATION_LUMINANCE, luminance);
  set(QUELL_INNOVATION_CHROMINANCE, chrominance);
  record[QUELL_CHANGE_AGREEMENT] = 0.0f;
}

void ChangeWeightCase::upload() {
  m_harness.upload("changeSums", inputs.sums);
  m_harness.upload("recentChangePrev", inputs.recentChangePrev);
}

Comparison ChangeWeightCase::compare() {
  Comparison comparison;
  const Planes device = weights();
  const ChangeWeightExact exact = changeWeightOracle(inputs);
  if (device.values.size() != exact.weights.values.size())
    comparison.include("number of weights", 0, 0, 0, std::numeric_limits<double>::infinity(), 0.0);
  comparePixels(comparison, "weight", device, exact.weights);
  comparePixels(comparison, "recentChange", recentChange(), exact.recentChange);
  return comparison;
}

}  // namespace quell::tests
