#include "tests/cases/change_inputs.hpp"

#include "kernels/accumulate_noisy_params.h"
#include "kernels/change_params.h"
#include "tests/cases/filter_inputs.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {

StageSetup makeChangeSetup(const CaseOptions& options, int signals, ChangeSettings settings) {
  StageSetup setup = makeSetup(options);
  setFilterMethod(setup, "quell", {signals, false});
  if (settings == ChangeSettings::Defaults) return setup;
  setup.settings.set("historyFrames", 6.0);
  setup.settings.set("stillHistoryFrames", kChangeHistoryFrames);
  setup.settings.set("momentsLeastWeight", kChangeMomentsLeastWeight);
  setup.settings.set("mostWeight", kChangeMostWeight);
  setup.settings.set("changeThreshold", kChangeThreshold);
  setup.settings.set("recentChangeThreshold", kRecentChangeThreshold);
  setup.settings.set("changeGain", kChangeGain);
  setup.settings.set("changeMemory", kChangeMemory);
  return setup;
}

std::vector<LightInput> lightOfRecords(Planes& sums) {
  std::vector<LightInput> inputs;
  for (std::size_t first = 0; first < sums.values.size(); first += QUELL_CHANGE_RECORD) {
    for (int plane = 0; plane < QUELL_INNOVATION_PLANES; ++plane) {
      inputs.push_back({&sums.values[first + QUELL_CHANGE_SUM(plane)], 1, 1});
      inputs.push_back({&sums.values[first + QUELL_CHANGE_SQUARES(plane)], 1, 2});
    }
  }
  return inputs;
}

Planes randomHistoryLengths(Size size, int signals, unsigned seed) {
  Random random(seed);
  Planes lengths(size, signals);
  for (float& length : lengths.values)
    length = float(random.integer(0, random.uniform() < 0.1 ? QUELL_MAX_HISTORY_LENGTH : 12));
  return lengths;
}

}  // namespace quell::tests
