// The commands of the quell tool. Each adds itself to the command line; its callback throws quell::Error,
// which main() turns into a message and exit code 1 (CLI11 answers usage errors itself).
#pragma once

#include <CLI/CLI.hpp>

namespace quell::cli {

void addDenoiseCommand(CLI::App& app);
void addCheckCommand(CLI::App& app);
void addCompareCommand(CLI::App& app);
void addBenchCommand(CLI::App& app);
void addDemoCommand(CLI::App& app);
void addDevicesCommand(CLI::App& app);
void addFBetaCommand(CLI::App& app);
void addKernelsCommand(CLI::App& app);
void addSelectFeaturesCommand(CLI::App& app);
void addStressCommand(CLI::App& app);
void addRenderCommand(CLI::App& app);
void addTuneDeviceCommand(CLI::App& app);
void addTuneCommand(CLI::App& app);

}  // namespace quell::cli
