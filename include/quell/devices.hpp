// Which OpenCL devices there are and which one to take.
#pragma once

#include <CL/cl.h>
#include <quell/api.h>

#include <cstddef>
#include <string>
#include <vector>

namespace quell {

/// A device as its runtime describes it.
struct DeviceInfo {
  cl_platform_id platform = nullptr;  ///< whose device it is; never null
  cl_device_id device = nullptr;      ///< never null; root devices need no release
  int index = 0;                      ///< over all platforms, in the order of enumeration
  std::string platformName;           ///< CL_PLATFORM_NAME
  std::string name;                   ///< CL_DEVICE_NAME
  std::string vendor;                 ///< CL_DEVICE_VENDOR
  std::string version;                ///< OpenCL version text of the device
  std::string driverVersion;          ///< CL_DRIVER_VERSION; part of the key of the disk cache
  std::string type;                   ///< "GPU", "CPU", "accelerator" or "other"
  unsigned computeUnits = 0;          ///< of a CPU its threads
  std::size_t localMemoryBytes = 0;   ///< per work-group
  std::size_t globalMemoryBytes = 0;  ///< all there is, not what is free
  std::size_t maxWorkGroup = 0;       ///< work-items
  bool images = false;                ///< CL_DEVICE_IMAGE_SUPPORT; without it images must be buffers
  bool halfArithmetic = false;        ///< cl_khr_fp16; Quell needs only half storage, which every device has
  bool profiling = false;             ///< event profiling; times can still turn out to be 0 on some runtimes
};

/// All available devices of all platforms; platforms without devices are skipped.
/// Throws Error(NoDevice) if there is no platform or no device at all, saying what to install.
QUELL_API std::vector<DeviceInfo> listDevices();

/// Picks a device. `spec` is empty (a GPU if there is one, else an accelerator, else a CPU; the first of its
/// kind), an index from listDevices(), or part of a device or platform name (case ignored). Throws
/// Error(NoDevice) if none fits, naming those there are.
QUELL_API DeviceInfo chooseDevice(const std::string& spec = "");

}  // namespace quell
