// quell bench: times, memory and errors of methods and settings, compared fairly.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/cli/bench_plan.hpp"
#include "host/cli/bench_report.hpp"
#include "host/cli/bench_runner.hpp"
#include "host/cli/command_arguments.hpp"
#include "host/cli/commands.hpp"
#include "host/io/atomic_file.hpp"

namespace quell::cli {
namespace {

// Settings varied so often that they have an option of their own.
constexpr const char* kShorthands[] = {"solver", "windows", "features"};
constexpr char kSeparator = ',';

struct BenchOptions {
  std::vector<std::string> methods = methodNames();
  std::vector<Variation> shorthands;  // one for each of kShorthands, without values unless given
  std::vector<std::string> variations;
  InputArguments input;
  DeviceArguments device;
  int repeat = 3;
  std::string json;
  std::string csv;
};

std::vector<Variation> allVariations(const BenchOptions& options) {
  std::vector<Variation> all;
  for (const Variation& variation : options.shorthands)
    if (!variation.values.empty()) all.push_back(variation);
  for (const std::string& text : options.variations) all.push_back(parseVariation(text));
  return all;
}

void runBenchCommand(const BenchOptions& options) {
  const std::vector<PlannedRun> runs = planRuns(options.methods, allVariations(options));
  const std::vector<BenchInput> inputs = openInputs(options.input);
  const BenchResult result = runBench(runs, inputs, options.repeat, options.device);
  print(result);
  std::fflush(stdout);  // the files may go to the same place
  if (!options.json.empty()) io::writeTextFile(options.json, toJson(result).dump(2) + "\n");
  if (!options.csv.empty()) io::writeTextFile(options.csv, toCsv(result));
}

void addPlanOptions(CLI::App& command, BenchOptions& options) {
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
}

void addInputOptions(CLI::App& command, InputArguments& input) {
  command.add_option("--input", input.directories, "Directories with sequences (see data/README.md)");
  command
      .add_option("--size", input.sizes,
                  "Sizes of the built-in sequence; default: 1280x720 if there is no --input")
      ->delimiter(kSeparator);
  command.add_option("--signals", input.signals, "1, or 2: diffuse and glossy light side by side")
      ->check(CLI::Range(1, 2))
      ->capture_default_str();
  command
      .add_option("--frames", input.mostFrames,
                  "Run the first N frames of every sequence; default: all, 16 of the built-in one")
      ->check(CLI::PositiveNumber);
}

}  // namespace

void addBenchCommand(CLI::App& app) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command =
      app.add_subcommand("bench", "Compare methods and settings: stage times, memory, errors");
  addPlanOptions(*command, *options);
  addInputOptions(*command, options->input);
  command->add_option("--repeat", options->repeat, "Timed rounds over every sequence, after a warm-up round")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addDeviceArguments(*command, options->device);
  command->add_option("--json", options->json, "File for all results as JSON");
  command->add_option("--csv", options->csv, "File for all results as a table");
  command->footer(settingsHelp("--vary"));
  command->callback([options] { runBenchCommand(*options); });
}

}  // namespace quell::cli
