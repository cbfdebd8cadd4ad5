// What quell tune-device keeps is what later runs do.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/core/tuning.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

// Hash of a short run whose cache is this directory.
std::string outputHash(const std::string& cache, const std::string& mapping) {
  const TemporaryDirectory directory;
  const std::string report = directory.file("report.json");
  // The sums over a tile are added up in another order by each mapping.
  REQUIRE(quell({"denoise", "--method", "bmfr", "--set", "solver=gram", "--size", "33x17", "--frame-count",
                 "1", "--mapping", mapping, "--cache-directory", cache, "--json", report}) == 0);
  return readJson(report).at("output_hash");
}

}  // namespace

TEST_CASE("a tuned device is used as it was tuned until that is forgotten", "[cli]") {
  const TemporaryDirectory cache;
  const DeviceTraits device = queryDeviceTraits(cl::Device(chooseDevice().device, true), Mapping::Automatic);
  const std::string usual = outputHash(cache.path(), "automatic");
  const int otherLanes = device.lanes == 1 ? 16 : 1;
  const std::string other = outputHash(cache.path(), device.lanes == 1 ? "wide" : "narrow");
  REQUIRE(usual != other);  // else this test would see nothing

  DeviceTuning tuning;
  for (const char* stage : {"accumulate_noisy", "gram_sums", "gram_solve", "weighted_sum",
                            "accumulate_filtered", "remodulate", "temporal_antialiasing"})
    tuning[stage] = {otherLanes, {4, 2}, 0};
  writeTuning(DiskCache(cache.path()), device.identity, tuning);
  CHECK(outputHash(cache.path(), "automatic") == other);
  REQUIRE(quell({"tune-device", "--forget", "--cache-directory", cache.path()}) == 0);
  CHECK(outputHash(cache.path(), "automatic") == usual);
}

TEST_CASE("tune-device answers mistakes", "[cli]") {
  const TemporaryDirectory cache;
  const auto tune = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"tune-device", "--cache-directory", cache.path()});
    return quell(more);
  };
  CHECK(tune({"--methods", "magic", "--size", "8x8"}) == 1);
  CHECK(tune({"--size", "banana"}) == 1);
  CHECK(tune({"--device", "no such device"}) == 1);
  CHECK(tune({"--frames", "0"}) != 0);
  CHECK(cache.entryCount() == 0);
}

}  // namespace quell::tests
