#include "host/core/device_traits.hpp"

#include <algorithm>
#include <iterator>

namespace quell {
namespace {

// PoCL 3.1. It keeps the machine code that it launches in a cache of its own, so nothing is lost without binaries.
constexpr char kPoclPlatform[] = "Portable Computing Language";

/// The first that fits; null where none does.
template <class Fits>
const MappingFacts* findFacts(Fits fits) {
  const auto found = std::find_if(std::begin(kMappings), std::end(kMappings), fits);
  return found == std::end(kMappings) ? nullptr : found;
}

/// What fills a vector register, as far as the device says so and kernels are written for it.
int nativeLanesOf(const cl::Device& device) {
  const auto width = static_cast<int>(device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>());
  int lanes = factsOf(Mapping::Wide4).lanes;
  for (const MappingFacts& facts : kMappings)
    if (facts.lanes <= width) lanes = std::max(lanes, facts.lanes);
  return lanes;
}

}  // namespace

const MappingFacts& factsOf(Mapping mapping) {
  return *findFacts([mapping](const MappingFacts& facts) { return facts.mapping == mapping; });
}

const MappingFacts* mappingNamed(const std::string& name) {
  return findFacts([&name](const MappingFacts& facts) { return facts.name == name; });
}

const MappingFacts* mappingWith(int lanes) {
  return findFacts([lanes](const MappingFacts& facts) { return lanes > 0 && facts.lanes == lanes; });
}

DeviceTraits queryDeviceTraits(const cl::Device& device, Mapping mapping) {
  DeviceTraits traits;
  traits.name = device.getInfo<CL_DEVICE_NAME>();
  traits.identity = device.getInfo<CL_DEVICE_VENDOR>() + "\n" + traits.name + "\n" +
                    device.getInfo<CL_DEVICE_VERSION>() + "\n" + device.getInfo<CL_DRIVER_VERSION>();
  traits.isCpu = (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) != 0;
  traits.nativeLanes = nativeLanesOf(device);
  if (mapping == Mapping::Automatic) mapping = traits.isCpu ? Mapping::Wide : Mapping::Narrow;
  traits.lanes = mapping == Mapping::Wide ? traits.nativeLanes : factsOf(mapping).lanes;
  traits.maxWorkGroup = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
  const cl::Platform platform(device.getInfo<CL_DEVICE_PLATFORM>(), true);
  traits.compilesForBinaries = platform.getInfo<CL_PLATFORM_NAME>() == kPoclPlatform;
  return traits;
}

}  // namespace quell
