// quell bench: times, memory and errors of methods and settings, compared fairly.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/cli/bench/compare.hpp"
#include "host/cli/bench/page.hpp"
#include "host/cli/bench/report.hpp"
#include "host/cli/bench/runner.hpp"
#include "host/cli/bench/sweeps.hpp"
#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/commands.hpp"
#include "host/cli/common/output_files.hpp"
#include "host/cli/common/run_plan.hpp"
#include "host/cli/common/sequence_arguments.hpp"
#include "host/io/atomic_file.hpp"

namespace quell::cli {
namespace {

// Settings varied so often that they have an option of their own.
constexpr const char* kShorthands[] = {"solver", "windows", "features"};
constexpr char kSeparator = ',';
// Making up a frame of 3840x2160 takes longer than to denoise it. Rounds keep the history, or all frames would be first
// ones, which take longer.
constexpr int kBuiltInSweepFrames = 3;

struct BenchArguments {
  std::vector<std::string> methods = methodNames();
  std::vector<Variation> shorthands;  // one for each of kShorthands, without values unless given
  std::vector<std::string> variations;
  std::vector<std::string> sweeps;
  InputArguments input;
  BenchOptions options;
  std::string operations;
  std::string json;
  std::string csv;
  std::string html;
  std::string compare;
};

std::vector<Variation> allVariations(const BenchArguments& arguments) {
  std::vector<Variation> all;
  for (const Variation& variation : arguments.shorthands)
    if (!variation.values.empty()) all.push_back(variation);
  for (const std::string& text : arguments.variations) all.push_back(parseVariation(text));
  return all;
}

// A sweep runs on one of the directories, or on sizes of its own.
BenchGroup planSweepGroup(const std::string& name, const BenchArguments& arguments) {
  InputArguments input = arguments.input;
  const std::vector<std::string> sizes = sweepSizes(name);
  if (!sizes.empty()) {
    input.directories.clear();
    input.sizes = sizes;
    input.reading.signals = 1;
    input.mostFrames = kBuiltInSweepFrames;
    if (const std::vector<double> shares = sweepSkyShares(name); !shares.empty()) input.skyShares = shares;
  } else if (!input.directories.empty()) {
    if (sweepNeedsRoughness(name))
      input.directories = {directoryWithRoughness(input.directories, input.reading)};
    else
      input.directories.resize(1);
    input.sizes.clear();
  }
  return {planSweep(name, arguments.methods), openInputs(input), !sizes.empty()};
}

std::vector<BenchGroup> planGroups(const BenchArguments& arguments) {
  std::vector<BenchGroup> groups;
  groups.push_back(
      {planRuns(arguments.methods, allVariations(arguments)), openInputs(arguments.input), false});
  for (const std::string& sweep : arguments.sweeps) groups.push_back(planSweepGroup(sweep, arguments));
  return groups;
}

void writeHtml(const BenchResult& result, const std::string& directory) {
  createDirectory("bench", directory);
  io::writeTextFile(directory + "/index.html", toHtml(result));
}

void runBenchCommand(const BenchArguments& arguments) {
  // Read first: nobody should wait for a benchmark to learn of a wrong file name.
  nlohmann::json before;
  if (!arguments.compare.empty()) before = readBench(arguments.compare);
  OperationCounts operations;
  if (!arguments.operations.empty()) operations = OperationCounts(arguments.operations);
  const std::vector<BenchGroup> groups = planGroups(arguments);
  BenchResult result = runBench(groups, arguments.options);
  result.operations = operations;
  print(result);
  std::fflush(stdout);  // the files may go to the same place
  writeJson(arguments.json, toJson(result));
  if (!arguments.csv.empty()) io::writeTextFile(arguments.csv, toCsv(result));
  if (!arguments.html.empty()) writeHtml(result, arguments.html);
  if (!arguments.compare.empty())
    fmt::print("\ncompared with {}:\n{}", arguments.compare,
               compareBench(before, toJson(result), arguments.compare));
}

void addPlanOptions(CLI::App& command, BenchArguments& options) {
  command.add_option("--methods", options.methods, "Methods to run")
      ->delimiter(kSeparator)
      ->capture_default_str();
  for (const char* setting : kShorthands) options.shorthands.push_back({setting, {}});
  for (Variation& shorthand : options.shorthands) {
    command
        .add_option("--" + shorthand.setting, shorthand.values,
                    fmt::format("Short for --vary {}=..., values separated by {}", shorthand.setting,
                                valueSeparator(shorthand.setting) == ';' ? "semicolons" : "commas"))
        ->delimiter(valueSeparator(shorthand.setting));
  }
  command.add_option("--vary", options.variations,
                     "A setting and its values, name=value,value (texts: separated by semicolons); may be "
                     "repeated: all combinations are run, "
                     "save those that the library refuses. A method without the setting ignores it");
  command
      .add_option("--sweep", options.sweeps,
                  "Also run named series: " + fmt::format("{}", fmt::join(sweepNames(), ", ")))
      ->delimiter(kSeparator)
      ->check(CLI::IsMember(sweepNames()));
}

void addReportOptions(CLI::App& command, BenchArguments& arguments) {
  BenchOptions& options = arguments.options;
  command.add_flag(
      "--roofline", options.fmaRate,
      "Also measure the rate of multiply-adds and report what memory and arithmetic allow at best");
  command.add_option("--operations", arguments.operations,
                     "Operations per pixel of the stages, for --roofline; from bench/count_operations");
  command.add_flag("--build-times", options.buildTimes, "Also measure how long kernels take to build");
  command.add_option("--pictures", options.pictureInputs, "Sequences whose pictures go into the page")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--json", arguments.json, "File for all results as JSON");
  command.add_option("--csv", arguments.csv, "File for all results as a table");
  command.add_option("--html", arguments.html, "Directory for a page with charts, pictures and all results");
  command.add_option("--compare", arguments.compare, "Earlier results (JSON): print what has changed since");
}

void addInputOptions(CLI::App& command, InputArguments& input) {
  command.add_option("--input", input.directories,
                     "Sequences: directories or files, as quell denoise takes them");
  command
      .add_option("--size", input.sizes,
                  "Sizes of the built-in sequence; default: 1280x720 if there is no --input")
      ->delimiter(kSeparator);
  addSignalsOption(command, input.reading.signals);
  addSequenceOptions(command, input.reading);
  command
      .add_option("--frames", input.mostFrames,
                  "Run the first N frames of every sequence; default: all, 16 of the built-in one")
      ->check(CLI::PositiveNumber);
}

}  // namespace

void addBenchCommand(CLI::App& app) {
  auto arguments = std::make_shared<BenchArguments>();
  arguments->options.rounds = 3;
  arguments->options.pictureInputs = 1;
  CLI::App* command =
      app.add_subcommand("bench", "Compare methods and settings: stage times, memory, errors");
  addPlanOptions(*command, *arguments);
  addInputOptions(*command, arguments->input);
  command
      ->add_option("--repeat", arguments->options.rounds,
                   "Timed rounds over every sequence, after a warm-up round")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addDeviceArguments(*command, arguments->options.device);
  addReportOptions(*command, *arguments);
  command->footer(settingsHelp("--vary"));
  command->callback([arguments] { runBenchCommand(*arguments); });
}

}  // namespace quell::cli
