// quell tune: the Pareto set on numbers given by hand, what it plans and stores, and what it refuses.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/cli/common/text_table.hpp"
#include "host/cli/tune/pareto_set.hpp"
#include "host/cli/tune/plan.hpp"
#include "host/cli/tune/result.hpp"
#include "host/io/atomic_file.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

int tune(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "tune");
  return quell(arguments);
}

// Links frames first..last of data/colonnade into a new directory, with the references among them.
std::string cutSequence(const TemporaryDirectory& parent, const std::string& name, int first, int last) {
  const std::string directory = parent.file(name);
  fs::create_directories(directory);
  fs::create_symlink(kData + "/camera.json", directory + "/camera.json");
  for (const auto& entry : fs::directory_iterator(kData)) {
    const std::string file = entry.path().filename().string();
    const std::size_t number = file.find_last_of('_');
    if (number == std::string::npos) continue;
    const int frame = std::stoi(file.substr(number + 1));
    if (frame >= first && frame <= last) fs::create_symlink(entry.path(), directory + "/" + file);
  }
  return directory;
}

std::string messageOf(const std::vector<std::string>& directories) {
  cli::InputArguments arguments;
  arguments.directories = directories;
  try {
    cli::checkReferences(cli::openInputs(arguments));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// Two sequences; figures of `scale` times some numbers.
cli::EvaluatedSetting evaluated(double first, double second) {
  return {{"quell", {}},
          {{4.0 * first, first, {0.05 * first, 0.9, 0.10 * first}},
           {9.0 * second, second, {0.02 * second, 0.8, 0.05 * second}}}};
}

cli::Evaluation twoSequences(const std::vector<cli::EvaluatedSetting>& settings) {
  cli::Evaluation evaluation;
  evaluation.sequences = {{"one", {8, 8}, 2, {1}, true}, {"two", {8, 8}, 2, {1}, true}};
  evaluation.settings = settings;
  return evaluation;
}

}  // namespace

TEST_CASE("the Pareto set holds what nothing beats in time, RMSE and FLIP at once", "[cli]") {
  CHECK(cli::paretoSet({}, 0.0).empty());
  const std::vector<cli::Costs> settings = {
      {1.0, {1.0, 1.0}},  // in it: nothing is better in all three
      {0.5, {1.2, 1.1}},  // in it: the quickest
      {0.6, {1.2, 1.1}},  // as good as the one before, but slower
      {2.0, {0.9, 1.0}},  // in it: the least RMSE
      {2.0, {1.0, 0.9}},  // in it: the least FLIP
      {2.0, {1.1, 1.1}},  // beaten by the first
      {1.0, {1.0, 1.0}},  // equal to the first
  };
  const std::vector<bool> expected = {true, true, false, true, true, false, true};
  CHECK(cli::paretoSet(settings, 0.0) == expected);
}

TEST_CASE("times within the tolerance count as equal", "[cli]") {
  const cli::Costs worse = {1.00, {1.1, 1.0}}, better = {1.01, {1.0, 1.0}};
  CHECK_FALSE(cli::dominates(better, worse, 0.0));
  CHECK(cli::dominates(better, worse, 0.02));
  CHECK_FALSE(cli::dominates(worse, better, 0.02));

  // Of times in small steps the quickest stays, and what is within its tolerance.
  const std::vector<cli::Costs> chain = {{1.00, {1, 1}}, {1.015, {1, 1}}, {1.03, {1, 1}}};
  CHECK(cli::paretoSet(chain, 0.02) == std::vector<bool>{true, true, false});
}

TEST_CASE("tune takes geometric means relative to the defaults", "[cli]") {
  const cli::TuningTable table =
      cli::summarize(twoSequences({evaluated(1.0, 1.0), evaluated(0.5, 0.8), evaluated(2.0, 0.5)}), 0.0);
  REQUIRE(table.settings.size() == 3);
  CHECK(table.settings[0].frameMs == Approx(6.0));  // of 4 and 9
  for (const auto& [setting, expected] : {std::pair{0, 1.0}, {1, std::sqrt(0.4)}, {2, 1.0}}) {
    CHECK(table.settings[static_cast<std::size_t>(setting)].relative.time == Approx(expected));
    const std::vector<double>& errors = table.settings[static_cast<std::size_t>(setting)].relative.errors;
    REQUIRE(errors.size() == 2);
    for (const double error : errors) CHECK(error == Approx(expected));
  }
  CHECK_FALSE(table.settings[0].pareto);
  CHECK(table.settings[1].pareto);
  CHECK_FALSE(table.settings[2].pareto);

  cli::EvaluatedSetting negative = evaluated(1.0, 1.0);
  negative.sequences[1].errors[0] = -0.001;
  CHECK_THROWS_WITH(cli::summarize(twoSequences({evaluated(1.0, 1.0), negative}), 0.0),
                    Catch::Contains("two") && Catch::Contains("above 0"));
}

TEST_CASE("tune runs the defaults first, and nothing twice", "[cli]") {
  cli::InputArguments arguments;
  arguments.sizes = {"32x16"};
  const std::vector<cli::BenchInput> inputs = cli::openInputs(arguments);
  const std::string byDefault = Settings("svgf").text("iterations");
  REQUIRE(byDefault == "5");
  const std::vector<cli::Variation> variations = {cli::parseVariation("iterations=4,5,4"),
                                                  cli::parseVariation("taa=on,off")};
  const std::vector<cli::PlannedRun> plans = cli::planTuning("svgf", variations, inputs);
  std::vector<std::string> names;
  for (const cli::PlannedRun& plan : plans) names.push_back(plan.settingsText());
  CHECK(names ==
        std::vector<std::string>{"", "iterations=4 taa=on", "iterations=4 taa=off", "iterations=5 taa=off"});
  CHECK(cli::defaultsText("svgf", variations) == "iterations=5 taa=on");
}

TEST_CASE("tables stand in columns and in Markdown", "[cli]") {
  const cli::TextTable table = {{"name", "x"}, {{"a|b", "10"}, {"longer", "1"}}};
  CHECK(cli::toText(table) == "name     x\na|b     10\nlonger   1\n");
  CHECK(cli::toMarkdown(table) == "| name | x |\n|---|---:|\n| a\\|b | 10 |\n| longer | 1 |\n");
}

TEST_CASE("tune writes the Pareto set, and what became of it on other sequences", "[cli]") {
  const TemporaryDirectory directory;
  const std::string tuned = cutSequence(directory, "tuned", 14, 15);
  const std::string confirmed = cutSequence(directory, "confirmed", 13, 15);
  const std::string file = directory.file("tune.json"), markdown = directory.file("tune.md");
  // Three settings in groups of two, so that the defaults run in each.
  REQUIRE(tune({"--method", "atrous", "--input", tuned, "--confirm", confirmed, "--vary", "iterations=1,3",
                "--repeat", "1", "--at-once", "2", "--json", file, "--markdown", markdown}) == 0);
  const json result = readJson(file);
  CHECK(result.at("method") == "atrous");
  CHECK(result.at("copy_ms").get<double>() > 0.0);
  const json& sequence = result.at("tuned").at("sequences").at(0);
  CHECK(sequence.at("name") == tuned);
  CHECK(sequence.at("references") == json::array({15}));
  CHECK((sequence.at("reference") == "centre" && sequence.at("unbiased") == true));

  const json& settings = result.at("tuned").at("settings");
  REQUIRE(settings.size() == 3);
  const json expected[] = {json::object(), {{"iterations", "1"}}, {{"iterations", "3"}}};
  for (std::size_t i = 0; i < 3; ++i) CHECK(settings[i].at("settings") == expected[i]);
  CHECK(settings[0].at("relative_rmse") == 1.0);
  CHECK(settings[0].at("relative_time") == 1.0);
  std::size_t best = 1;  // the defaults go along
  for (const json& setting : settings) {
    const json& figures = setting.at("sequences").at(0);
    CHECK(figures.at("frame_ms").get<double>() > 0.0);
    CHECK(figures.at("ssim").get<double>() > 0.0);
    CHECK(setting.at("relative_rmse").get<double>() ==
          Approx(figures.at("unbiased_rmse").get<double>() /
                 settings[0].at("sequences").at(0).at("unbiased_rmse").get<double>()));
    if (setting.at("pareto").get<bool>() && !setting.at("settings").empty()) ++best;
  }
  CHECK(settings[1].at("relative_rmse").get<double>() > 1.0);  // one iteration leaves noise
  CHECK(result.at("confirmed").at("settings").size() == best);
  CHECK(result.at("confirmed").at("sequences").at(0).at("references") == json::array({15}));

  // The figures are those of quell denoise.
  const std::string report = directory.file("denoise.json");
  REQUIRE(quell({"denoise", "--method", "atrous", "--set", "iterations=3", "--input", tuned, "--json",
                 report}) == 0);
  const json denoised = readJson(report), linear = denoised.at("errors").at(0).at("linear");
  const json& third = settings[2].at("sequences").at(0);
  for (const char* figure : {"unbiased_rmse", "ssim", "flip"})
    CHECK(third.at(figure).get<double>() == Approx(linear.at(figure).get<double>()));
  CHECK(third.at("temporal_error").get<double>() == Approx(denoised.at("temporal_error").get<double>()));

  CHECK_THAT(io::readFile(markdown), Catch::Contains("Tuned on:") && Catch::Contains(tuned) &&
                                         Catch::Contains("Confirmed on") && Catch::Contains(confirmed) &&
                                         Catch::Contains("| iterations=3 |"));
}

TEST_CASE("tune goes on without settings that the library refuses", "[cli]") {
  const TemporaryDirectory directory;
  const std::string sequence = cutSequence(directory, "one", 15, 15);
  const std::string file = directory.file("tune.json");
  // Householder's solver, the default, has no overlapping windows.
  REQUIRE(tune({"--method", "bmfr", "--input", sequence, "--vary", "windows=overlap", "--repeat", "1",
                "--json", file}) == 0);
  const json tuned = readJson(file).at("tuned");
  REQUIRE(tuned.at("settings").size() == 1);  // the defaults
  REQUIRE(tuned.at("refused").size() == 1);
  CHECK(tuned.at("refused")[0].at("settings") == "windows=overlap");
  CHECK(tuned.at("refused")[0].at("sequence") == sequence);
}

TEST_CASE("tune answers mistakes", "[cli]") {
  const TemporaryDirectory directory;
  const std::string without = cutSequence(directory, "without", 8, 9);
  CHECK_THAT(messageOf({kData, without}),
             Catch::Contains(without) && Catch::Contains("reference") && Catch::Contains("8-9"));
  CHECK(messageOf({kData}).empty());
  CHECK(tune({"--input", without, "--vary", "iterations=3"}) == 1);
  CHECK(tune({"--input", kData, "--confirm", without, "--vary", "iterations=3"}) == 1);
  CHECK(tune({"--input", kData, "--frames", "2", "--vary", "iterations=3"}) ==
        1);  // the reference comes later

  CHECK_THROWS_WITH(cli::checkApart({"a", kData}, {kData + "/../colonnade/"}), Catch::Contains("--confirm"));
  CHECK_NOTHROW(cli::checkApart({kData}, {without}));
  CHECK(tune({"--input", kData, "--confirm", kData, "--vary", "iterations=3"}) == 1);

  CHECK(tune({"--vary", "iterations=3"}) != 0);
  CHECK(tune({"--input", kData}) != 0);
  CHECK(tune({"--input", kData, "--vary", "magic=1"}) == 1);
  CHECK(tune({"--input", kData, "--vary", "iterations=-1"}) == 1);
  CHECK(tune({"--input", kData, "--vary", "iterations=1", "--vary", "iterations=2"}) == 1);
  CHECK(tune({"--input", kData, "--vary", "iterations=1", "--at-once", "1"}) != 0);
  CHECK(tune({"--input", directory.file("none"), "--vary", "iterations=3"}) == 1);
}

}  // namespace quell::tests
