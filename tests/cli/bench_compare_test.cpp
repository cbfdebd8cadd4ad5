// What quell bench says has changed since earlier results.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <quell/error.hpp>
#include <string>
#include <vector>

#include "host/cli/bench/compare.hpp"

namespace quell::tests {
namespace {

using nlohmann::json;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A result as far as comparisons read it.
json resultOf(const std::vector<double>& rounds, double rmse, double ssim) {
  const json errors = {
      {{"frame", 3},
       {"linear", {{"rmse", rmse}, {"unbiased_rmse", nullptr}, {"ssim", ssim}, {"flip", 0.1}}}}};
  return {{"runs",
           {{{"run", "bmfr"},
             {"input", "room"},
             {"width", 8},
             {"height", 8},
             {"frames", 4},
             {"copy_ms", 2.0},
             {"round_medians_ms", rounds},
             {"errors", errors},
             {"temporal_error", 0.01}}}}};
}

}  // namespace

TEST_CASE("bench says what changed beyond noise", "[cli]") {
  const json before = resultOf({4.0, 4.4, 4.2}, 0.1, 0.8);
  const auto compared = [&](const json& now) { return cli::compareBench(before, now, "old.json"); };
  CHECK(compared(before) == "1 runs compared: 0 slower, 0 faster; 0 figures worse, 0 better\n");
  CHECK(contains(compared(resultOf({4.6, 4.3, 4.5}, 0.1, 0.8)), " 0 slower, 0 faster"));
  CHECK(contains(compared(resultOf({4.6, 4.7, 4.5}, 0.1, 0.8)),
                 "slower: bmfr on room, 8x8, 4 frames: 2.2 to 2.4 copies"));
  CHECK(contains(compared(resultOf({3.6, 3.7, 3.5}, 0.1, 0.8)), "faster: bmfr on room"));
  CHECK(contains(compared(resultOf({4.2}, 0.102, 0.8)),
                 "worse: bmfr on room, 8x8, 4 frames, frame 3: rmse 0.102, was 0.1"));
  CHECK(contains(compared(resultOf({4.2}, 0.1, 0.78)), "worse: bmfr on room, 8x8, 4 frames, frame 3: ssim"));
  CHECK(contains(compared(resultOf({4.2}, 0.09, 0.8)), " 0 figures worse, 1 better"));
  CHECK(contains(compared({{"runs", json::array()}}), "0 runs compared"));
  json longer = before, swept = before, huge = before;
  huge["runs"][0]["height"] = 9e110;  // no integer there is
  CHECK(contains(compared(huge), "0 runs compared"));
  longer["runs"][0]["frames"] = 8;
  swept["runs"][0]["sweep"] = "sizes";
  CHECK(contains(compared(longer), "0 runs compared"));
  CHECK(contains(compared(swept), "0 runs compared"));
  CHECK_THROWS_AS(cli::compareBench({{"runs", {{{"run", "bmfr"}}}}}, before, "old.json"), Error);
}

}  // namespace quell::tests
