// quell bench as a user runs it: what it runs, skips, stores and refuses. Never how fast anything was.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "host/cli/bench/roofline.hpp"
#include "host/cli/common/run_plan.hpp"
#include "host/io/atomic_file.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

using nlohmann::json;
using namespace std::string_literals;

// Runs the bench with what all tests share added.
int bench(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "bench");
  arguments.insert(arguments.end(), {"--frames", "3", "--repeat", "1"});
  return quell(std::move(arguments));
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

std::ptrdiff_t commas(const std::string& line) { return std::count(line.begin(), line.end(), ','); }

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("bench stores stage times beside the copy bandwidth", "[cli]") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("bench.json");
  REQUIRE(bench({"--methods", "bmfr", "--solver", "householder,gram", "--size", "64x48", "--json", file}) ==
          0);
  const json result = readJson(file);
  CHECK(result.at("copy_ms").get<double>() > 0.0);
  CHECK(result.at("copy_gbs").get<double>() > 0.0);
  CHECK(result.at("copy_gbs_measured").size() == 2);
  CHECK(result.at("repeat") == 1);
  CHECK(result.at("skipped").empty());
  REQUIRE(result.at("runs").size() == 2);
  CHECK(result.at("runs")[0].at("settings").at("solver") == "householder");
  CHECK(result.at("runs")[1].at("settings").at("solver") == "gram");
  for (const json& run : result.at("runs")) {
    CHECK(run.at("method") == "bmfr");
    CHECK(run.at("width") == 64);
    CHECK(run.at("height") == 48);
    CHECK(run.at("frames") == 3);
    CHECK(run.at("copy_ms") == result.at("copy_ms"));
    CHECK(run.at("memory_bytes").get<double>() > 0.0);
    CHECK(run.at("frame_ms").at("median").get<double>() > 0.0);
    CHECK((run.at("time_source") == "device" || run.at("time_source") == "host"));
    REQUIRE_FALSE(run.at("stages").empty());
    for (const json& stage : run.at("stages")) {
      CHECK(stage.at("min_ms").get<double>() <= stage.at("median_ms").get<double>());
      CHECK(stage.at("median_ms").get<double>() <= stage.at("max_ms").get<double>());
      CHECK(stage.at("bytes").get<double>() > 0.0);
      for (const char* figure : {"gbs", "copies", "copy_share"}) CHECK(stage.at(figure).get<double>() >= 0.0);
    }
  }
}

TEST_CASE("bench skips what the library refuses, size by size", "[cli]") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("bench.json");
  REQUIRE(bench({"--methods", "bmfr", "--solver", "householder,gram", "--windows", "blocks,overlap", "--vary",
                 "taa=off", "--size", "64x48,33x17", "--json", file}) == 0);
  const json result = readJson(file);
  REQUIRE(result.at("runs").size() == 2 * 3);
  CHECK(result.at("runs")[0].at("width") == 64);
  CHECK(result.at("runs")[5].at("width") == 33);
  REQUIRE(result.at("skipped").size() == 2);
  CHECK(result.at("skipped")[0].at("run") == "bmfr solver=householder windows=overlap taa=off");
  CHECK(result.at("skipped")[1].at("width") == 33);
}

TEST_CASE("bench gives the output of denoise, and its errors, whatever runs beside", "[cli]") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("bench.json"), alone = directory.file("denoise.json");
  REQUIRE(quell({"bench", "--methods", "bmfr", "--solver", "gram,householder", "--input", kData, "--frames",
                 "12", "--repeat", "1", "--json", file}) == 0);
  REQUIRE(quell({"denoise", "--method", "bmfr", "--input", kData, "--frames", "4-15", "--set",
                 "solver=householder", "--json", alone}) == 0);
  const json run = readJson(file).at("runs").at(1), denoised = readJson(alone);
  CHECK(run.at("output_hash") == denoised.at("output_hash"));
  CHECK(run.at("settings") == denoised.at("settings"));
  CHECK(run.at("errors") == denoised.at("errors"));
  CHECK(run.at("input") == kData);
  CHECK(run.at("errors").at(0).at("frame") == 15);
}

TEST_CASE("bench writes a table whose lines are all alike", "[cli]") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("bench.csv"), report = directory.file("bench.json");
  REQUIRE(quell({"bench", "--methods", "bmfr", "--input", kData, "--size", "64x48", "--frames", "12",
                 "--repeat", "1", "--csv", file, "--json", report}) == 0);
  const std::vector<std::string> table = lines(io::readFile(file));
  std::size_t expected = 1;  // the header
  const json result = readJson(report);
  REQUIRE(result.at("runs").size() == 2);
  for (const json& run : result.at("runs"))
    expected += run.at("stages").size() + 2 + 3 * run.value("errors", json::array()).size();
  REQUIRE(table.size() == expected);
  CHECK(contains(table[0], "input,method,settings,width,height,"));
  for (const std::string& line : table)
    if (!contains(line, "\"")) CHECK(commas(line) == commas(table[0]));
  CHECK(contains(table[1], ",stage,accumulate_noisy,"));
  const auto count = [&](const std::string& part) {
    return std::count_if(table.begin(), table.end(), [&](const auto& line) { return contains(line, part); });
  };
  CHECK(count(",sum,sum of stages,") == 2);
  CHECK(count(",error,frame 15 linear,") == 1);
  CHECK(count(",centre,") == 3);  // noisy, linear and display
  CHECK(count("\"analytic room, seed 1\",bmfr,") > 0);
}

TEST_CASE("bench answers mistakes and leaves no file", "[cli]") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("bench.json");
  const auto refuses = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", file});
    return bench(std::move(arguments)) != 0;
  };
  CHECK(refuses({"--methods", "magic"}));
  CHECK(refuses({"--vary", "nothing=1", "--size", "8x8"}));
  CHECK(refuses({"--vary", "taaNewestWeight=7", "--size", "8x8"}));
  CHECK(refuses({"--vary", "taa", "--size", "8x8"}));
  CHECK(refuses({"--solver", "magic", "--size", "8x8"}));
  CHECK(refuses({"--size", "0x10"}));
  CHECK(refuses({"--size", "64x48,banana"}));
  CHECK(refuses({"--input", directory.file("none")}));
  CHECK(refuses({"--size", "8x8", "--device", "no such device"}));
  CHECK(refuses({"--methods", "bmfr", "--solver", "householder", "--windows", "overlap", "--size", "8x8"}));
  CHECK(refuses({"--sweep", "magic", "--size", "8x8"}));
  CHECK(refuses({"--compare", directory.file("none"), "--size", "8x8"}));
  CHECK(refuses({"--compare", kData + "/README.md", "--size", "8x8"}));
  CHECK(refuses({"--operations", directory.file("none"), "--size", "8x8"}));
  CHECK(quell({"bench", "--size", "8x8", "--frames", "0"}) != 0);
  CHECK(quell({"bench", "--size", "8x8", "--repeat", "0"}) != 0);
  CHECK(directory.entryCount() == 0);
  CHECK(bench({"--size", "8x8", "--json", directory.file("missing/bench.json")}) == 1);
}

TEST_CASE("the sweep of F_beta says what it needs where that is missing", "[cli]") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("bench.json");
  REQUIRE(bench({"--methods", "atrous", "--input", kData, "--sweep", "fbeta", "--json", file}) == 0);
  const json result = readJson(file);
  REQUIRE(result.at("skipped").size() == 1);
  CHECK(result.at("skipped")[0].at("run") == "atrous demodulate=fbeta");
  CHECK(contains(result.at("skipped")[0].at("reason"), "roughness"));
}

TEST_CASE("what is skipped does not count as bytes moved", "[cli]") {
  const TemporaryDirectory directory;
  const auto varianceOf = [&](const std::string& skip) {
    const std::string file = directory.file("denoise.json");
    REQUIRE(quell({"denoise", "--size", "64x48", "--frame-count", "2", "--sky-share", "0.5", "--set",
                   "skip=" + skip, "--json", file}) == 0);
    const json stages = readJson(file).at("stages");
    return *std::find_if(stages.begin(), stages.end(),
                         [](const json& s) { return s.at("name") == "variance"; });
  };
  const json all = varianceOf("off"), some = varianceOf("on");
  CHECK_FALSE(all.contains("skipped_share"));
  const double share = some.at("skipped_share");
  CHECK(share >= 0.5);
  constexpr double kMap = 0.01;  // the map of what is background, over the images
  CHECK(some.at("bytes").get<double>() ==
        Approx((1.0 - share) * all.at("bytes").get<double>()).epsilon(kMap));
}

TEST_CASE("operations are those of the pixels that a stage works on", "[cli]") {
  StageTimings stage;
  CHECK(cli::workShare(stage) == 1.0);
  stage.skippedShare = 0.75;
  CHECK(cli::workShare(stage) == 0.25);
}

TEST_CASE("bench adds roofline, build times, sweeps and a page", "[cli]") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("bench.json"), counts = directory.file("counts.json");
  constexpr double kPerPixel = 1000.0;
  io::writeTextFile(counts, R"json({"atrous": {"remodulate": 1000, "atrous (step 1)": 1e9}})json");
  REQUIRE(
      bench({"--methods", "atrous", "--size", "64x48", "--sweep", "iterations", "--roofline", "--operations",
             counts, "--build-times", "--json", file, "--html", directory.file("page")}) == 0);
  const json result = readJson(file);
  CHECK(result.at("fma_gflops").get<double>() > 0.0);
  REQUIRE(result.at("runs").size() == 1 + 7);
  const json &main = result.at("runs")[0], &swept = result.at("runs")[7];
  CHECK(main.at("build_ms").at("cold").get<double>() > 0.0);
  CHECK(main.at("build_ms").at("cached").get<double>() > 0.0);
  CHECK_FALSE(main.contains("sweep"));
  CHECK(swept.at("sweep") == "iterations");
  CHECK(swept.at("assignments").at("iterations") == "7");
  CHECK(main.at("round_medians_ms").size() == 1);
  CHECK(main.at("frame_medians_ms").size() == 3);
  const json& stages = main.at("stages");
  CHECK(stages[1].at("label") == "atrous (step 1)");
  CHECK(stages[2].at("label") == "atrous (step 2)");
  const double flopsBound = 1e9 * 64 * 48 * 1e-6 / result.at("fma_gflops").get<double>();
  CHECK(stages[1].at("bound_ms").get<double>() == Approx(flopsBound));
  const double bytesBound = stages[2].at("bytes").get<double>() * 1e-6 / result.at("copy_gbs").get<double>();
  CHECK(stages[2].at("bound_ms").get<double>() == Approx(bytesBound));
  CHECK_FALSE(stages[2].contains("operations"));
  CHECK(stages.back().at("operations").get<double>() == kPerPixel * 64 * 48);

  const std::string page = io::readFile(directory.file("page") + "/index.html");
  CHECK(contains(page, "</html>"));
  CHECK(contains(page, "class Comparer"));
  CHECK(contains(page, "A prediction, not a measurement"));
  CHECK(contains(page, "\"sweep\":\"iterations\""));
  CHECK_FALSE(contains(page, "@"s + "INCLUDE"));
  CHECK_FALSE(contains(page, "@"s + "RESULTS"));
}

TEST_CASE("bench puts pictures of every method into the page", "[cli]") {
  const TemporaryDirectory directory;
  REQUIRE(quell({"bench", "--methods", "atrous", "--input", kData, "--frames", "12", "--repeat", "1",
                 "--html", directory.path()}) == 0);
  const std::string page = io::readFile(directory.file("index.html"));
  for (const char* name : {"noisy", "reference", "atrous"})
    CHECK(
        contains(page, "\"name\":\"" + std::string(name) + "\",\"png\":\"data:image/png;base64,iVBORw0KGgo"));
}

TEST_CASE("bench takes lists of features, separated by semicolons", "[cli]") {
  const TemporaryDirectory directory;
  const std::string file = directory.path() + "/bench.json";
  REQUIRE(bench({"--methods", "bmfr", "--features", "1,n;1,n,w", "--size", "64x48", "--json", file}) == 0);
  const json runs = readJson(file).at("runs");
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].at("settings").at("features") == "1,n");
  CHECK(runs[1].at("settings").at("features") == "1,n,w");
  CHECK(runs[0].at("output_hash") != runs[1].at("output_hash"));
  const cli::Variation variation = cli::parseVariation("features=n;w,w2");
  CHECK(variation.values == std::vector<std::string>{"n", "w,w2"});
}

}  // namespace quell::tests
