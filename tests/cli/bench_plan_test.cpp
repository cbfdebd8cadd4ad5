// What quell bench runs, and on which sequences.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "host/cli/bench/sweeps.hpp"
#include "host/cli/common/run_plan.hpp"
#include "host/io/exr_image.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

std::vector<std::string> namesOf(const std::vector<cli::PlannedRun>& runs) {
  std::vector<std::string> names;
  for (const cli::PlannedRun& run : runs) names.push_back(run.name());
  return names;
}

ErrorCode codeOfPlan(const std::vector<std::string>& methods, const std::vector<cli::Variation>& variations) {
  try {
    cli::planRuns(methods, variations);
  } catch (const Error& error) {
    return error.code();
  }
  FAIL("planned");
  return {};
}

}  // namespace

TEST_CASE("bench plans all combinations of methods and values", "[cli]") {
  CHECK(namesOf(cli::planRuns({"bmfr"}, {})) == std::vector<std::string>{"bmfr"});
  const cli::Variation solver = cli::parseVariation("solver=householder,gram");
  const cli::Variation taa = cli::parseVariation("taa=off");
  CHECK(namesOf(cli::planRuns({"bmfr"}, {solver, taa})) ==
        std::vector<std::string>{"bmfr solver=householder taa=off", "bmfr solver=gram taa=off"});
}

TEST_CASE("bench refuses what no method knows", "[cli]") {
  CHECK(codeOfPlan({"magic"}, {}) == ErrorCode::UnknownSetting);
  CHECK(codeOfPlan({"bmfr"}, {{"nothing", {"1"}}}) == ErrorCode::UnknownSetting);
  CHECK(codeOfPlan({"bmfr"}, {{"solver", {"gram", "magic"}}}) == ErrorCode::OutOfRange);
  CHECK(codeOfPlan({"bmfr"}, {{"taa", {"on"}}, {"taa", {"off"}}}) == ErrorCode::InvalidArgument);
  CHECK_THROWS_AS(cli::parseVariation("solver"), Error);
  CHECK_THROWS_AS(cli::parseVariation("solver="), Error);
}

TEST_CASE("bench runs sweeps beside the main runs, on the first input or on sizes of their own", "[cli]") {
  CHECK(namesOf(cli::planSweep("storage", {"svgf", "bmfr"})) ==
        std::vector<std::string>{"bmfr solver=householder featureStorage=float",
                                 "bmfr solver=householder featureStorage=half"});
  CHECK(cli::planSweep("features", {"bmfr"}).size() == 2 * 5);
  CHECK(cli::planSweep("iterations", {"svgf", "atrous"}).size() == 2 * 7);
  CHECK(cli::sweepSizes("sizes").size() == 5);
  CHECK(cli::sweepSizes("taa").empty());
  CHECK(namesOf(cli::planSweep("background", {"quell", "bmfr", "svgf", "atrous"})) ==
        std::vector<std::string>{"quell skip=on", "quell skip=off", "bmfr skip=on", "bmfr skip=off",
                                 "svgf skip=on", "svgf skip=off", "atrous skip=on", "atrous skip=off"});
  CHECK(cli::sweepSkyShares("background") == std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0});
  CHECK(cli::sweepSkyShares("sizes").empty());
  CHECK_THROWS_AS(cli::planSweep("windows", {"atrous"}), Error);
  for (const std::string& sweep : cli::sweepNames()) {
    for (const cli::PlannedRun& run : cli::planSweep(sweep, methodNames())) {
      CHECK(run.sweep == sweep);
      Settings settings(run.method);
      for (const auto& [setting, value] : run.assignments) CHECK_NOTHROW(settings.set(setting, value));
    }
  }
}

TEST_CASE("bench opens the built-in sequence once for every size and share of sky", "[cli]") {
  cli::InputArguments arguments;
  arguments.sizes = {"8x6", "16x9"};
  arguments.skyShares = {0.0, 0.25, 1.0};
  const std::vector<cli::BenchInput> inputs = cli::openInputs(arguments);
  REQUIRE(inputs.size() == 2 * 3);
  CHECK(inputs[1].sequence->name() == "analytic room, seed 1, 25 % sky");
  CHECK(inputs[1].sequence->width() == 8);
  CHECK(inputs[3].sequence->name() == "analytic room, seed 1");
  CHECK(inputs[5].sequence->width() == 16);
}

TEST_CASE("the sweep of F_beta runs on the first directory with roughness", "[cli]") {
  const TemporaryDirectory directory;
  const std::string rough = directory.file("rough");
  std::filesystem::copy(kData, rough);
  const io::Image albedo = io::readExr(rough + "/albedo_0004.exr");
  for (int frame = 4; frame < 16; ++frame)
    io::writeExr(fmt::format("{}/roughness_{:04}.exr", rough, frame),
                 io::Image(albedo.width, albedo.height, 1));
  CHECK(cli::directoryWithRoughness({kData, rough}) == rough);
  CHECK(cli::directoryWithRoughness({rough, kData}) == rough);
  CHECK(cli::directoryWithRoughness({kData}) == kData);
}

}  // namespace quell::tests
