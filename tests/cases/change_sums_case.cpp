#include "tests/cases/change_sums_case.hpp"

#include <limits>

#include "tests/support/random_images.hpp"

namespace quell::tests {

ChangeSumsCase::ChangeSumsCase(const CaseOptions& options, int signals)
    : StageCase("change_sums", makeChangeSetup(options, signals)) {
  inputs.innovation =
      randomPlanes(options.size, QUELL_INNOVATION_PLANES * signals, options.seed + 10, -4.0, 8.0);
  inputs.historyLength = randomHistoryLengths(options.size, signals, options.seed + 20);
  const int records = TileGrid(options.size).count() * signals;
  inputs.sumsPrev = randomPlanes({records * QUELL_CHANGE_RECORD, 1}, 1, options.seed + 30, -20.0, 80.0);
  useFrame(1);
}

void ChangeSumsCase::useFrame(std::uint32_t frameIndex) {
  m_frameIndex = frameIndex;
  inputs.sumsKept = frameIndex > 0 ? kChangeMemory : 0.0;
}

void ChangeSumsCase::upload() {
  m_harness.upload("innovation", inputs.innovation);
  m_harness.upload("historyLength", inputs.historyLength);
  m_harness.upload("changeSumsPrev", inputs.sumsPrev);
}

Comparison ChangeSumsCase::compare() {
  Comparison comparison;
  const Planes device = sums();
  const ChangeSumsExact exact = changeSumsOracle(inputs);
  if (device.values.size() != exact.sums.values.size())
    comparison.include("number of sums", 0, 0, 0, std::numeric_limits<double>::infinity(), 0.0);
  for (int i = 0; i < exact.sums.width; ++i) {
    const double magnitude = exact.magnitudes.at(0, i, 0);
    // What nothing was added to must be 0.
    comparison.include("sum", 0, i, 0, device.at(0, i, 0), exact.sums.at(0, i, 0),
                       magnitude > 0.0 ? magnitude : 1.0);
  }
  return comparison;
}

}  // namespace quell::tests
