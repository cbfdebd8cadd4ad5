// What was measured to be fastest on a device, stage by stage; kept beside the compiled kernels.
#pragma once

#include <array>
#include <map>
#include <string>

#include "host/core/disk_cache.hpp"
#include "host/core/schedule.hpp"

namespace quell {

/// How one stage runs best.
struct StageTuning {
  int lanes = 1;                       ///< pixels per work-item, as one of kMappings has them
  std::array<int, 2> workGroup{0, 0};  ///< as Options::workGroup
  int fitGroup = 0;                    ///< as Options::fitGroup
};

/// Stage name -> tuning; stages that are not in it run as everywhere.
using DeviceTuning = std::map<std::string, StageTuning>;

/// Of the device with this identity (see DeviceTraits); empty where nothing usable is kept.
DeviceTuning readTuning(const DiskCache& disk, const std::string& deviceIdentity);
/// Replaces what is kept; an empty one means that nothing was measured.
void writeTuning(const DiskCache& disk, const std::string& deviceIdentity, const DeviceTuning& tuning);

/// Puts a stage's tuning into the configuration that it is built with. Options that the caller has set stay: nothing
/// changes unless mapping, work-group and fit group are all left to the library.
void applyTuning(const DeviceTuning& tuning, const std::string& stage, Configuration& configuration);

/// Pixels per work-item for stages that must agree on them: what most of those that were measured want (the more where as many do), else, and where
/// the caller has set options, as the configuration has it.
int commonLanes(const DeviceTuning& tuning, const std::vector<std::string>& stages,
                const Configuration& configuration);

}  // namespace quell
