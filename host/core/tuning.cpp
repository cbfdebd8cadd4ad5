#include "host/core/tuning.hpp"

#include <algorithm>
#include <sstream>

namespace quell {
namespace {

constexpr char kFormat[] = "quell tuning 1";
constexpr int kMostItems = 4096;  // of a work-group, along each axis
constexpr int kMostFitGroup = 256;

std::string keyOf(const std::string& deviceIdentity) { return std::string(kFormat) + "\n" + deviceIdentity; }

bool isUsable(const StageTuning& tuning) {
  const auto inRange = [](int value, int most) { return value >= 0 && value <= most; };
  return mappingWith(tuning.lanes) != nullptr && inRange(tuning.workGroup[0], kMostItems) &&
         inRange(tuning.workGroup[1], kMostItems) && inRange(tuning.fitGroup, kMostFitGroup) &&
         (tuning.fitGroup & (tuning.fitGroup - 1)) == 0;
}

/// Whether the caller has chosen what tuning would choose.
bool hasOptions(const Options& options) {
  return options.mapping != Mapping::Automatic || options.workGroup != std::array<int, 2>{0, 0} ||
         options.fitGroup != 0;
}

}  // namespace

DeviceTuning readTuning(const DiskCache& disk, const std::string& deviceIdentity) {
  const auto bytes = disk.read(keyOf(deviceIdentity));
  if (!bytes) return {};
  std::istringstream text(std::string(bytes->begin(), bytes->end()));
  DeviceTuning tuning;
  std::string format, stage;
  std::getline(text, format);
  for (StageTuning t; text >> stage >> t.lanes >> t.workGroup[0] >> t.workGroup[1] >> t.fitGroup;)
    if (isUsable(t)) tuning[stage] = t;
  return tuning;
}

void writeTuning(const DiskCache& disk, const std::string& deviceIdentity, const DeviceTuning& tuning) {
  std::ostringstream text;
  text << kFormat << '\n';
  for (const auto& [stage, t] : tuning)
    text << stage << ' ' << t.lanes << ' ' << t.workGroup[0] << ' ' << t.workGroup[1] << ' ' << t.fitGroup
         << '\n';
  const std::string bytes = text.str();
  disk.write(keyOf(deviceIdentity), DiskCache::Bytes(bytes.begin(), bytes.end()));
}

void applyTuning(const DeviceTuning& tuning, const std::string& stage, Configuration& configuration) {
  const auto found = tuning.find(stage);
  if (hasOptions(configuration.options) || found == tuning.end()) return;
  configuration.device.lanes = found->second.lanes;
  configuration.options.workGroup = found->second.workGroup;
  configuration.options.fitGroup = found->second.fitGroup;
}

int commonLanes(const DeviceTuning& tuning, const std::vector<std::string>& stages,
                const Configuration& configuration) {
  if (hasOptions(configuration.options)) return configuration.device.lanes;
  std::map<int, int> wishes;  // lanes to the number of stages
  for (const std::string& stage : stages) {
    const auto found = tuning.find(stage);
    if (found != tuning.end()) ++wishes[found->second.lanes];
  }
  const auto most =
      std::max_element(wishes.begin(), wishes.end(), [](auto a, auto b) { return a.second <= b.second; });
  return most == wishes.end() ? configuration.device.lanes : most->first;
}

}  // namespace quell
