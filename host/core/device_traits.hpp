// What the choice of kernel variants depends on.
#pragma once

#include <quell/denoiser.hpp>
#include <string>

#include "host/core/opencl.hpp"

namespace quell {

/// How many pixels a work-item of the per-pixel kernels takes, its lanes; see kernels/common/lanes.h.
struct MappingFacts {
  const char* name;
  Mapping mapping;
  int lanes;  ///< 0: depends on the device
};
constexpr MappingFacts kMappings[] = {{"automatic", Mapping::Automatic, 0}, {"narrow", Mapping::Narrow, 1},
                                      {"wide", Mapping::Wide, 0},           {"wide4", Mapping::Wide4, 4},
                                      {"wide8", Mapping::Wide8, 8},         {"wide16", Mapping::Wide16, 16}};
constexpr int kNarrowLanes = 1;

const MappingFacts& factsOf(Mapping mapping);
/// Null for an unknown name.
const MappingFacts* mappingNamed(const std::string& name);
/// The mapping that has so many lanes whatever the device; null for another number.
const MappingFacts* mappingWith(int lanes);

struct DeviceTraits {
  std::string name;
  std::string identity;  ///< vendor, name, version and driver: what a compiled program is valid for
  bool isCpu = false;
  int lanes = kNarrowLanes;  ///< pixels per work-item, one of kMappings
  int nativeLanes = 4;       ///< of Mapping::Wide
  std::size_t maxWorkGroup = 1;
  /// To give a program's binary the runtime compiles every kernel once more, for a work-group of any size.
  bool compilesForBinaries = false;
};

DeviceTraits queryDeviceTraits(const cl::Device& device, Mapping mapping);

}  // namespace quell
