// The commands of the quell tool. Each adds itself to the command line; its callback throws quell::Error,
// which main() turns into a message and exit code 1, as it does with errors in the command line.
#pragma once

// Declarations alone: what CLI11 defines inline in its further headers takes seconds to compile, once in run_tool.cpp.
#include <CLI/App.hpp>

namespace quell::cli {

void addDenoiseCommand(CLI::App& app);
void addCheckCommand(CLI::App& app);
void addCompareCommand(CLI::App& app);
void addBenchCommand(CLI::App& app);
void addDemoCommand(CLI::App& app);
void addDevicesCommand(CLI::App& app);
void addFBetaCommand(CLI::App& app);
void addKernelsCommand(CLI::App& app);
void addManualCommands(CLI::App& app);
void addSelectFeaturesCommand(CLI::App& app);
void addStressCommand(CLI::App& app);
void addRenderCommand(CLI::App& app);
void addReplayCommand(CLI::App& app);
void addTuneDeviceCommand(CLI::App& app);
void addTuneCommand(CLI::App& app);

}  // namespace quell::cli
