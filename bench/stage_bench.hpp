// The stages as benchmark cases. Inputs, oracle, tolerance and bytes come from tests/cases.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/cases/stage_case.hpp"

namespace quell::bench {

/// A stage in one variant: which images, which layout, which mapping.
struct StageEntry {
  std::string name;  ///< stage.variant
  std::function<std::unique_ptr<tests::StageCase>(Size)> make;
};
std::vector<StageEntry> stageEntries();

struct StageTimes {
  double medianMs = 0.0;
  double minMs = 0.0;
  double maxMs = 0.0;
  std::uint64_t bytesMoved = 0;
};

/// Compares a small run with the oracle, then times `repeat` runs of this size after a warm-up. Throws
/// std::runtime_error if the result is wrong.
StageTimes timeStage(const StageEntry& entry, Size size, int repeat);

}  // namespace quell::bench
