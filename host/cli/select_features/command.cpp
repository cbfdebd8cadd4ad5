// quell select-features: which features lower the error the most, one after the other.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "host/cli/common/commands.hpp"
#include "host/cli/common/output_files.hpp"
#include "host/cli/common/sequence_arguments.hpp"
#include "host/cli/select_features/selection.hpp"
#include "kernels/fit_params.h"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "select-features";

struct SelectOptions {
  SelectionArguments selection;
  std::string solver = "gram";
  std::string windows = "blocks";
  std::vector<std::string> settings;
  std::string json;
};

void runSelectFeatures(const SelectOptions& options) {
  SelectionArguments selection = options.selection;
  selection.settings = {{"solver", options.solver}, {"windows", options.windows}};
  for (const std::string& text : options.settings)
    selection.settings.push_back(parseAssignment(kCommand, "--set", text));
  const std::vector<SelectionStep> steps = selectFeatures(selection);
  print(steps);
  std::fflush(stdout);  // the file may go to the same place
  writeJson(options.json, toJson(steps));
}

}  // namespace

void addSelectFeaturesCommand(CLI::App& app) {
  auto options = std::make_shared<SelectOptions>();
  SelectionArguments& selection = options->selection;
  CLI::App* command = app.add_subcommand(
      kCommand,
      "Choose the features of bmfr's fit greedily by their error over the reference frames of sequences");
  command->add_option("--input", selection.inputs, "Sequences, as quell denoise takes them")->required();
  addSequenceOptions(*command, selection.reading);
  command->add_option(
      "--pool", selection.pool,
      "Features to choose from, as in the setting features; groups are added whole. Default: powers "
      "and roots of n and w, products of positions, depth, gradients, and albedo and roughness where all "
      "sequences have them");
  command->add_option("--start", selection.start, "Features to start from")->capture_default_str();
  command->add_flag("--components", selection.components, "Add the components of groups one by one");
  command->add_option("--count", selection.mostFeatures, "Stop at this many scalar features")
      ->check(CLI::Range(1, QUELL_MOST_FEATURES))
      ->capture_default_str();
  command->add_option("--solver", options->solver, "As the setting solver")->capture_default_str();
  command->add_option("--windows", options->windows, "As the setting windows")->capture_default_str();
  command->add_option("--set", options->settings, "Another setting of bmfr, name=value; may be repeated");
  addDeviceArguments(*command, selection.device);
  command->add_option("--json", options->json, "File for the steps as JSON");
  command->callback([options] { runSelectFeatures(*options); });
}

}  // namespace quell::cli
