// Listing and choosing devices.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <quell/devices.hpp>

#include "tests/support/error_matcher.hpp"

namespace quell::tests {

TEST_CASE("devices are listed with an index and what is needed to tell them apart", "[core]") {
  const std::vector<DeviceInfo> devices = listDevices();
  REQUIRE_FALSE(devices.empty());
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const DeviceInfo& info = devices[i];
    CHECK(info.index == static_cast<int>(i));
    CHECK(info.platform != nullptr);
    CHECK(info.device != nullptr);
    for (const std::string& text :
         {info.name, info.platformName, info.version, info.driverVersion, info.type})
      CHECK_FALSE(text.empty());
    CHECK(info.computeUnits > 0);
    CHECK(info.globalMemoryBytes > 0);
    CHECK(info.localMemoryBytes > 0);
    CHECK(info.maxWorkGroup > 0);
  }
}

TEST_CASE("a device is chosen by index", "[core]") {
  for (const DeviceInfo& info : listDevices())
    CHECK(chooseDevice(std::to_string(info.index)).device == info.device);
}

TEST_CASE("a device is chosen by part of its name or its platform's, in any case", "[core]") {
  const DeviceInfo first = listDevices().front();
  std::string shouted = first.name;
  std::transform(shouted.begin(), shouted.end(), shouted.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  CHECK(chooseDevice(first.name).name == first.name);
  CHECK(chooseDevice(shouted).name == first.name);
  CHECK(chooseDevice(first.name.substr(0, 4)).name.find(first.name.substr(0, 4)) != std::string::npos);
  CHECK(chooseDevice(first.platformName).platformName == first.platformName);
}

TEST_CASE("without a wish a GPU comes before an accelerator before a CPU", "[core]") {
  const auto rank = [](const DeviceInfo& info) {
    return info.type == "GPU" ? 0 : info.type == "accelerator" ? 1 : info.type == "CPU" ? 2 : 3;
  };
  const DeviceInfo chosen = chooseDevice();
  for (const DeviceInfo& info : listDevices()) {
    CHECK(rank(chosen) <= rank(info));
    if (rank(info) == rank(chosen)) CHECK(chosen.index <= info.index);
  }
}

TEST_CASE("an unknown device is refused with a list of those there are", "[core]") {
  const DeviceInfo first = listDevices().front();
  for (const char* spec : {"no such device", "9999", "-1"})
    REQUIRE_THROWS_MATCHES(chooseDevice(spec), Error,
                           failsWith(ErrorCode::NoDevice, {spec, "0: " + first.name}));
}

}  // namespace quell::tests
