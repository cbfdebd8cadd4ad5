#include "host/cli/tune/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "host/cli/common/command_arguments.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "tune";

bool sameSettings(const PlannedRun& a, const PlannedRun& b, const io::FrameSequence& sequence) {
  const Settings first = a.settings(sequence), second = b.settings(sequence);
  const std::vector<SettingDescription>& all = first.descriptions();
  return std::all_of(all.begin(), all.end(), [&](const SettingDescription& setting) {
    return first.text(setting.name) == second.text(setting.name);
  });
}

bool sameOnAll(const PlannedRun& a, const PlannedRun& b, const std::vector<BenchInput>& inputs) {
  return std::all_of(inputs.begin(), inputs.end(),
                     [&](const BenchInput& input) { return sameSettings(a, b, *input.sequence); });
}

bool hasReference(const BenchInput& input) {
  const io::References references(*input.sequence);
  return std::any_of(input.frames.begin(), input.frames.end(),
                     [&](int frame) { return references.has(frame); });
}

}  // namespace

std::vector<PlannedRun> planTuning(const std::string& method, const std::vector<Variation>& variations,
                                   const std::vector<BenchInput>& inputs) {
  std::vector<PlannedRun> plans = {{method, {}}};
  for (const PlannedRun& run : planRuns({method}, variations)) {
    const bool known = std::any_of(plans.begin(), plans.end(), [&](const PlannedRun& earlier) {
      return sameOnAll(run, earlier, inputs);
    });
    if (!known) plans.push_back(run);
  }
  return plans;
}

std::string defaultsText(const std::string& method, const std::vector<Variation>& variations) {
  const Settings defaults(method);
  std::string text;
  for (const Variation& variation : variations)
    text +=
        fmt::format("{}{}={}", text.empty() ? "" : " ", variation.setting, defaults.text(variation.setting));
  return text;
}

void checkApart(const std::vector<std::string>& tuned, const std::vector<std::string>& confirmed) {
  namespace fs = std::filesystem;
  const auto plain = [](const std::string& directory) {
    return fs::weakly_canonical(fs::path(directory) / "");
  };
  for (const std::string& directory : confirmed)
    for (const std::string& other : tuned)
      if (plain(directory) == plain(other))
        refuse(kCommand, "--confirm", "a sequence that is not in --input", directory);
}

void checkReferences(const std::vector<BenchInput>& inputs) {
  for (const BenchInput& input : inputs) {
    const std::string name = input.sequence->name();
    const std::string frames = fmt::format("frames {}-{}", input.frames.front(), input.frames.back());
    if (!hasReference(input))
      refuse(kCommand, name, "at least one frame with a reference", fmt::format("none in {}", frames));
    if (!input.sequence->read(input.frames.front()).comparable())
      refuse(kCommand, name, "light that can be compared with a reference", "demodulated light only");
  }
}

}  // namespace quell::cli
