#include "host/cli/bench/sweeps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/cli/common/command_arguments.hpp"

namespace quell::cli {
namespace {

using Variations = std::vector<Variation>;

struct Sweep {
  std::string name;
  std::vector<Variations> alternatives;  // each is planned by itself: all its combinations
  std::vector<std::string> sizes = {};
  std::vector<double> skyShares = {};
  bool needsRoughness = false;
};

const std::vector<Sweep>& sweeps() {
  const std::vector<std::string> weights = {"0.05", "0.1", "0.2", "0.5", "1"};
  // 4, 7, 10, 13 and 16 scalars, the constant included.
  const std::vector<std::string> features = {"n", "n,w", "n,w,w2", "n,w,w2,w3", "n,w,w2,w3,w*w"};
  static const std::vector<Sweep> all = {
      {"sizes", {{}}, {"320x180", "640x360", "1280x720", "1920x1080", "3840x2160"}},
      {"background", {{{"skip", {"on", "off"}}}}, {"1280x720"}, {0.0, 0.25, 0.5, 0.75, 1.0}},
      {"features", {{{"solver", {"householder", "gram"}}, {"features", features}}}},
      {"windows",
       {{{"solver", {"gram"}}, {"windows", {"blocks"}}},
        {{"solver", {"gram"}}, {"windows", {"overlap"}}, {"tileSize", {"8", "16"}}}}},
      {"iterations", {{{"iterations", {"1", "2", "3", "4", "5", "6", "7"}}}}},
      {"weight",
       {{{"irradianceLeastWeight", weights}, {"noisyLeastWeight", weights}},
        // For what is at rest historyFrames counts as well: it is the longer one.
        {{"historyFrames", {"20", "10", "5", "2", "1"}}, {"stillHistoryFrames", {"1"}}}}},
      {"storage", {{{"solver", {"householder"}}, {"featureStorage", {"float", "half"}}}}},
      {"taa", {{{"taa", {"on", "off"}}}}},
      {"fbeta", {{{"demodulate", {"albedo", "fbeta"}}}}, {}, {}, true},
  };
  return all;
}

const Sweep& findSweep(const std::string& name) {
  for (const Sweep& sweep : sweeps())
    if (sweep.name == name) return sweep;
  refuse("bench", "--sweep", fmt::format("one of {}", fmt::join(sweepNames(), ", ")), name);
}

bool hasAny(const std::string& method, const Variations& variations) {
  return variations.empty() || std::any_of(variations.begin(), variations.end(),
                                           [&](const Variation& v) { return hasSetting(method, v.setting); });
}

}  // namespace

std::vector<std::string> sweepNames() {
  std::vector<std::string> names;
  for (const Sweep& sweep : sweeps()) names.push_back(sweep.name);
  return names;
}

std::vector<PlannedRun> planSweep(const std::string& name, const std::vector<std::string>& methods) {
  std::vector<PlannedRun> runs;
  for (const Variations& alternative : findSweep(name).alternatives) {
    for (const std::string& method : methods) {
      if (!hasAny(method, alternative)) continue;
      Variations known;
      std::copy_if(alternative.begin(), alternative.end(), std::back_inserter(known),
                   [&](const Variation& v) { return hasSetting(method, v.setting); });
      for (PlannedRun& run : planRuns({method}, known)) runs.push_back(std::move(run));
    }
  }
  if (runs.empty())
    refuse("bench", "--sweep", "a method with the settings of " + name,
           fmt::format("{}", fmt::join(methods, ", ")));
  for (PlannedRun& run : runs) run.sweep = name;
  return runs;
}

std::vector<std::string> sweepSizes(const std::string& name) { return findSweep(name).sizes; }

bool sweepNeedsRoughness(const std::string& name) { return findSweep(name).needsRoughness; }

std::vector<double> sweepSkyShares(const std::string& name) { return findSweep(name).skyShares; }

}  // namespace quell::cli
