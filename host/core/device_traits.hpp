// What the choice of kernel variants depends on.
#pragma once

#include <quell/denoiser.hpp>
#include <string>

#include "host/core/opencl.hpp"

namespace quell {

struct DeviceTraits {
  std::string name;
  std::string identity;  ///< vendor, name, version and driver: what a compiled program is valid for
  bool isCpu = false;
  int lanes = 1;  ///< pixels per work-item of the per-pixel kernels, 1 or 16
  std::size_t maxWorkGroup = 1;
  /// To give a program's binary the runtime compiles every kernel once more, for a work-group of any size.
  bool compilesForBinaries = false;
};

DeviceTraits queryDeviceTraits(const cl::Device& device, Mapping mapping);

}  // namespace quell
