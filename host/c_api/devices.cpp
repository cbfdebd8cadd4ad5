#include <quell/devices.hpp>

#include "host/c_api/boundary.hpp"

namespace quell::c_api {
namespace {

void copyText(char (&target)[QUELL_TEXT_LENGTH], const std::string& text) {
  target[text.copy(target, QUELL_TEXT_LENGTH - 1)] = '\0';
}

quell_device_info toC(const DeviceInfo& info) {
  quell_device_info result{};
  result.platform = info.platform;
  result.device = info.device;
  result.index = info.index;
  copyText(result.platformName, info.platformName);
  copyText(result.name, info.name);
  copyText(result.vendor, info.vendor);
  copyText(result.version, info.version);
  copyText(result.driverVersion, info.driverVersion);
  copyText(result.type, info.type);
  result.computeUnits = info.computeUnits;
  result.localMemoryBytes = info.localMemoryBytes;
  result.globalMemoryBytes = info.globalMemoryBytes;
  result.maxWorkGroup = info.maxWorkGroup;
  result.images = info.images ? 1 : 0;
  result.halfArithmetic = info.halfArithmetic ? 1 : 0;
  result.profiling = info.profiling ? 1 : 0;
  return result;
}

}  // namespace
}  // namespace quell::c_api

using namespace quell::c_api;

extern "C" {

quell_status quellCountDevices(size_t* count) {
  return guarded("quellCountDevices", [&] {
    require(count, "quellCountDevices", "count");
    *count = quell::listDevices().size();
  });
}

quell_status quellGetDevice(size_t index, quell_device_info* info) {
  return guarded("quellGetDevice", [&] {
    const std::vector<quell::DeviceInfo> devices = quell::listDevices();
    requireIndex(index, devices.size(), "quellGetDevice", "index");
    writeStruct(info, toC(devices[index]), "quellGetDevice", "info");
  });
}

quell_status quellChooseDevice(const char* spec, quell_device_info* info) {
  return guarded("quellChooseDevice", [&] {
    writeStruct(info, toC(quell::chooseDevice(spec == nullptr ? "" : spec)), "quellChooseDevice", "info");
  });
}

}  // extern "C"
