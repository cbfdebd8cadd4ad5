// What tune-device keeps: read back, applied to what the caller left open, and never trusted blindly.
#include "host/core/tuning.hpp"

#include <catch2/catch.hpp>

#include "tests/support/temporary_directory.hpp"

namespace quell::tests {
namespace {

const DeviceTuning kTuning = {{"atrous", {1, {64, 2}, 0}}, {"gram_sums", {16, {0, 0}, 4}}};

Configuration configurationFor(const Options& options) {
  Configuration configuration{{}, options, Settings("svgf"), {}, {}};
  configuration.device.lanes = 16;
  return configuration;
}

}  // namespace

TEST_CASE("tuning is kept for each device", "[core]") {
  const TemporaryDirectory directory;
  const DiskCache disk(directory.path());
  CHECK(readTuning(disk, "device A").empty());
  writeTuning(disk, "device A", kTuning);
  const DeviceTuning read = readTuning(disk, "device A");
  REQUIRE(read.size() == 2);
  CHECK(read.at("atrous").lanes == 1);
  CHECK(read.at("atrous").workGroup == std::array<int, 2>{64, 2});
  CHECK(read.at("gram_sums").fitGroup == 4);
  CHECK(readTuning(disk, "device B").empty());
  writeTuning(disk, "device A", {});
  CHECK(readTuning(disk, "device A").empty());
}

TEST_CASE("unusable tuning is left out", "[core]") {
  const TemporaryDirectory directory;
  const DiskCache disk(directory.path());
  writeTuning(disk, "device",
              {{"fine", {1, {8, 8}, 64}},
               {"lanes", {3, {0, 0}, 0}},
               {"negative", {1, {-1, 4}, 0}},
               {"group", {1, {0, 0}, 48}},
               {"large", {1, {1 << 20, 1}, 0}}});
  const DeviceTuning read = readTuning(disk, "device");
  CHECK(read.size() == 1);
  CHECK(read.count("fine") == 1);
}

TEST_CASE("tuning changes what the caller left to the library, and nothing else", "[core]") {
  Configuration open = configurationFor({});
  applyTuning(kTuning, "atrous", open);
  CHECK(open.device.lanes == 1);
  CHECK(open.options.workGroup == std::array<int, 2>{64, 2});
  Configuration unknown = configurationFor({});
  applyTuning(kTuning, "variance", unknown);
  CHECK(unknown.device.lanes == 16);

  Options mapping, workGroup, fitGroup;
  mapping.mapping = Mapping::Wide;
  workGroup.workGroup = {8, 1};
  fitGroup.fitGroup = 32;
  for (const Options& options : {mapping, workGroup, fitGroup}) {
    Configuration chosen = configurationFor(options);
    applyTuning(kTuning, "atrous", chosen);
    CHECK(chosen.device.lanes == 16);
    CHECK(chosen.options.workGroup == options.workGroup);
  }
}

}  // namespace quell::tests
