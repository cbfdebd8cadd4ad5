// quell tune: settings of a method over sequences, and which of them are worth choosing from.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "host/cli/common/commands.hpp"
#include "host/cli/common/output_files.hpp"
#include "host/cli/common/sequence_arguments.hpp"
#include "host/cli/tune/plan.hpp"
#include "host/cli/tune/report.hpp"
#include "host/io/atomic_file.hpp"

namespace quell::cli {
namespace {

// As a share: about what medians of equal settings differ by on a machine that does other things, too.
constexpr double kTimeTolerance = 0.02;

struct TuneArguments {
  std::string method = Settings().method();
  InputArguments input;
  std::vector<std::string> confirm;
  std::vector<std::string> variations;
  double timeTolerance = kTimeTolerance;
  EvaluationArguments evaluation;
  std::string json;
  std::string markdown;
};

std::vector<BenchInput> openConfirmation(const TuneArguments& arguments) {
  if (arguments.confirm.empty()) return {};
  InputArguments input = arguments.input;
  input.directories = arguments.confirm;
  return openInputs(input);
}

void runTune(const TuneArguments& arguments) {
  checkApart(arguments.input.directories, arguments.confirm);
  std::vector<Variation> variations;
  for (const std::string& text : arguments.variations) variations.push_back(parseVariation(text));
  const std::vector<BenchInput> inputs = openInputs(arguments.input);
  const std::vector<BenchInput> confirmation = openConfirmation(arguments);
  const std::vector<PlannedRun> plans = planTuning(arguments.method, variations, inputs);
  checkReferences(inputs);
  checkReferences(confirmation);
  const TuningResult result = tune({arguments.method, defaultsText(arguments.method, variations),
                                    arguments.timeTolerance, arguments.evaluation},
                                   plans, inputs, confirmation);
  fmt::print("{}", toText(result));
  std::fflush(stdout);  // the files may go to the same place
  writeJson(arguments.json, toJson(result));
  if (!arguments.markdown.empty()) io::writeTextFile(arguments.markdown, toMarkdown(result));
}

void addInputOptions(CLI::App& command, TuneArguments& arguments) {
  command
      .add_option("--input", arguments.input.directories,
                  "Sequences to tune on, as quell denoise takes them, each with a reference")
      ->required();
  command.add_option("--confirm", arguments.confirm,
                     "Other sequences, to see whether the Pareto set holds there");
  addSignalsOption(command, arguments.input.reading.signals);
  addSequenceOptions(command, arguments.input.reading);
  command
      .add_option("--frames", arguments.input.mostFrames,
                  "Run the first N frames of every sequence; default: all")
      ->check(CLI::PositiveNumber);
}

void addTimeOptions(CLI::App& command, TuneArguments& arguments) {
  command
      .add_option("--repeat", arguments.evaluation.rounds,
                  "Timed rounds over every sequence, after the round that measures errors")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      .add_option(
          "--at-once", arguments.evaluation.atOnce,
          "Settings that run side by side, frame by frame, the defaults always among them; memory grows "
          "with it")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  command
      .add_option("--time-tolerance", arguments.timeTolerance,
                  "Times that differ by up to this share count as equal in the Pareto set")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

}  // namespace

void addTuneCommand(CLI::App& app) {
  auto arguments = std::make_shared<TuneArguments>();
  CLI::App* command = app.add_subcommand(
      "tune", "Run settings of a method over sequences: errors, times, and the Pareto set of both");
  command->add_option("--method", arguments->method, "Method")
      ->check(CLI::IsMember(methodNames()))
      ->capture_default_str();
  command
      ->add_option(
          "--vary", arguments->variations,
          "A setting and its values, name=value,value (texts: separated by semicolons); may be repeated: "
          "all combinations are run, and the defaults")
      ->required();
  addInputOptions(*command, *arguments);
  addTimeOptions(*command, *arguments);
  addDeviceArguments(*command, arguments->evaluation.device);
  command->add_option("--json", arguments->json, "File for all figures as JSON");
  command->add_option("--markdown", arguments->markdown, "File for the tables as Markdown");
  command->footer(settingsHelp("--vary"));
  command->callback([arguments] { runTune(*arguments); });
}

}  // namespace quell::cli
