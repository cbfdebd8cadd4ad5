// What the choice of kernel variants depends on.
#pragma once

#include <quell/denoiser.hpp>
#include <string>

#include "host/core/opencl.hpp"

namespace quell {

/// Pixels per work-item of the per-pixel kernels; see kernels/common/lanes.h.
constexpr int kNarrowLanes = 1;
constexpr int kWideLanes = 16;

struct DeviceTraits {
  std::string name;
  std::string identity;  ///< vendor, name, version and driver: what a compiled program is valid for
  bool isCpu = false;
  int lanes = kNarrowLanes;  ///< or kWideLanes
  std::size_t maxWorkGroup = 1;
  /// To give a program's binary the runtime compiles every kernel once more, for a work-group of any size.
  bool compilesForBinaries = false;
};

DeviceTraits queryDeviceTraits(const cl::Device& device, Mapping mapping);

}  // namespace quell
