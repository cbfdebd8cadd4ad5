// quell devices: what OpenCL offers and which device would be taken.
#include <fmt/format.h>

#include <quell/devices.hpp>

#include "host/cli/common/commands.hpp"
#include "host/cli/common/figures.hpp"

namespace quell::cli {
namespace {

const char* yesNo(bool value) { return value ? "yes" : "no"; }

void printDevices() {
  const std::vector<DeviceInfo> devices = listDevices();
  const DeviceInfo chosen = chooseDevice();
  for (const DeviceInfo& info : devices) {
    fmt::print("{} {}: {}\n", info.index == chosen.index ? "*" : " ", info.index, info.name);
    fmt::print("     platform        {}\n", info.platformName);
    fmt::print("     type            {}, {} compute units\n", info.type, info.computeUnits);
    fmt::print("     version         {} (driver {})\n", info.version, info.driverVersion);
    fmt::print("     global memory   {:.0f} MiB\n", mebibytes(info.globalMemoryBytes));
    fmt::print("     local memory    {} KiB per work-group of at most {} work-items\n",
               info.localMemoryBytes / 1024, info.maxWorkGroup);
    fmt::print("     event profiling {}   images {}   half arithmetic {} (not needed)\n",
               yesNo(info.profiling), yesNo(info.images), yesNo(info.halfArithmetic));
  }
  fmt::print("* is taken unless --device names another by index or by part of its name.\n");
}

}  // namespace

void addDevicesCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("devices", "List OpenCL devices and the one that would be chosen");
  command->callback(printDevices);
}

}  // namespace quell::cli
