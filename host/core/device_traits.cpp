#include "host/core/device_traits.hpp"

namespace quell {
namespace {

// PoCL 3.1. It keeps the machine code that it launches in a cache of its own, so nothing is lost without binaries.
constexpr char kPoclPlatform[] = "Portable Computing Language";

}  // namespace

DeviceTraits queryDeviceTraits(const cl::Device& device, Mapping mapping) {
  DeviceTraits traits;
  traits.name = device.getInfo<CL_DEVICE_NAME>();
  traits.identity = device.getInfo<CL_DEVICE_VENDOR>() + "\n" + traits.name + "\n" +
                    device.getInfo<CL_DEVICE_VERSION>() + "\n" + device.getInfo<CL_DRIVER_VERSION>();
  traits.isCpu = (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) != 0;
  const bool wide = mapping == Mapping::Wide || (mapping == Mapping::Automatic && traits.isCpu);
  traits.lanes = wide ? kWideLanes : kNarrowLanes;
  traits.maxWorkGroup = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
  const cl::Platform platform(device.getInfo<CL_DEVICE_PLATFORM>(), true);
  traits.compilesForBinaries = platform.getInfo<CL_PLATFORM_NAME>() == kPoclPlatform;
  return traits;
}

}  // namespace quell
