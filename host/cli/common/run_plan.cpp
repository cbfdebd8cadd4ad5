#include "host/cli/common/run_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "host/analytic/sequence.hpp"
#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/watched_sequence.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "bench";
constexpr char kDefaultSize[] = "1280x720";
constexpr int kBuiltInFrames = 16;

// True unless the method refuses this value of a setting that it has.
bool takes(const std::string& method, const std::string& setting, const std::string& value) {
  try {
    Settings(method).set(setting, value);
    return true;
  } catch (const Error& error) {
    if (error.code() == ErrorCode::OutOfRange) return false;
    throw;
  }
}

// A setting or value that suits only some of the methods is fine, one that suits none is a slip.
void checkVariation(const std::vector<std::string>& methods, const Variation& variation) {
  std::vector<std::string> having;
  std::copy_if(methods.begin(), methods.end(), std::back_inserter(having),
               [&](const std::string& method) { return hasSetting(method, variation.setting); });
  if (having.empty()) Settings(methods.front()).get(variation.setting);  // throws, naming those there are
  for (const std::string& value : variation.values) {
    const bool taken = std::any_of(having.begin(), having.end(), [&](const std::string& method) {
      return takes(method, variation.setting, value);
    });
    if (!taken) Settings(having.front()).set(variation.setting, value);  // throws, naming the range
  }
}

void checkVariations(const std::vector<std::string>& methods, const std::vector<Variation>& variations) {
  std::set<std::string> seen;
  for (const Variation& variation : variations) {
    if (!seen.insert(variation.setting).second)
      refuse(kCommand, variation.setting, "one list of values for each setting", "two");
    checkVariation(methods, variation);
  }
}

std::vector<PlannedRun> vary(const std::vector<PlannedRun>& runs, const Variation& variation) {
  std::vector<PlannedRun> varied;
  for (const PlannedRun& run : runs) {
    for (const std::string& value : variation.values) {
      varied.push_back(run);
      varied.back().assignments.emplace_back(variation.setting, value);
    }
  }
  return varied;
}

std::unique_ptr<io::FrameSequence> makeBuiltIn(Size size, double skyShare, int mostFrames) {
  io::AnalyticOptions analytic;
  analytic.width = size.width;
  analytic.height = size.height;
  analytic.frameCount = mostFrames > 0 ? mostFrames : kBuiltInFrames;
  analytic.skyShare = skyShare;
  return io::makeAnalyticSequence(analytic);
}

BenchInput openInput(std::unique_ptr<io::FrameSequence> sequence, int mostFrames) {
  std::vector<int> frames = sequence->frames();
  if (mostFrames > 0) frames.resize(std::min(frames.size(), static_cast<std::size_t>(mostFrames)));
  sequence->requireReadable(frames);
  return {std::move(sequence), std::move(frames)};
}

}  // namespace

char valueSeparator(const std::string& setting) {
  for (const std::string& method : methodNames())
    for (const SettingDescription& description : methodSettings(method))
      if (description.name == setting && description.kind == SettingKind::Text) return ';';
  return ',';
}

Variation parseVariation(const std::string& text) {
  const auto [setting, values] = parseAssignment(kCommand, "--vary", text);
  Variation variation = {setting, {}};
  std::istringstream list(values);
  for (std::string value; std::getline(list, value, valueSeparator(setting));)
    variation.values.push_back(value);
  if (variation.values.empty()) refuse(kCommand, "--vary", "name=value,value", text);
  return variation;
}

std::string PlannedRun::settingsText() const {
  std::string text;
  for (const auto& [setting, value] : assignments)
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", setting, value);
  return text;
}

std::string PlannedRun::name() const { return assignments.empty() ? method : method + " " + settingsText(); }

Settings PlannedRun::settings(const io::FrameSequence& sequence) const {
  Settings settings = defaultSettings(method, sequence);
  for (const auto& [setting, value] : assignments) settings.set(setting, value);
  return settings;
}

std::vector<PlannedRun> planRuns(const std::vector<std::string>& methods,
                                 const std::vector<Variation>& variations) {
  for (const std::string& method : methods) methodSettings(method);  // throws if there is no such method
  checkVariations(methods, variations);
  std::vector<PlannedRun> all;
  for (const std::string& method : methods) {
    std::vector<PlannedRun> runs = {{method, {}}};
    for (const Variation& variation : variations)
      if (hasSetting(method, variation.setting)) runs = vary(runs, variation);
    all.insert(all.end(), runs.begin(), runs.end());
  }
  return all;
}

std::string directoryWithRoughness(const std::vector<std::string>& directories,
                                   const io::SequenceOptions& reading) {
  for (const std::string& directory : directories) {
    const auto sequence = io::openSequence(directory, reading);
    if (!sequence->read(sequence->frames().front()).roughness.empty()) return directory;
  }
  return directories.front();
}

std::vector<BenchInput> openInputs(const InputArguments& arguments) {
  std::vector<BenchInput> inputs;
  for (const std::string& directory : arguments.directories)
    inputs.push_back(openInput(openWatched(directory, arguments.reading), arguments.mostFrames));
  std::vector<std::string> sizes = arguments.sizes;
  if (inputs.empty() && sizes.empty()) sizes = {kDefaultSize};
  if (!sizes.empty() && arguments.reading.signals != 1)
    refuse(kCommand, "--signals", "1 with the built-in sequence", std::to_string(arguments.reading.signals));
  for (const std::string& text : sizes) {
    const Size size = parseSize(kCommand, text);
    for (const double share : arguments.skyShares)
      inputs.push_back(openInput(makeBuiltIn(size, share, arguments.mostFrames), arguments.mostFrames));
  }
  return inputs;
}

}  // namespace quell::cli
