// Arguments of all commands that read frame sequences from files.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// --channels, --renderer, --layer, --view and --missing. `options` must live as long as `command`.
void addSequenceOptions(CLI::App& command, io::SequenceOptions& options);

/// --signals: 1, or 2 for diffuse and glossy light side by side. `signals` must live as long as `command`.
void addSignalsOption(CLI::App& command, int& signals);

/// Those of `frames` (ascending) that --frames asks for, all for an empty text. Throws Error(InvalidArgument): another form, a
/// range that goes beyond them, or one in which all are missing.
std::vector<int> chooseFrames(const char* command, std::vector<int> frames, const std::string& range);

/// The last `count` of `frames` (ascending) before `first`; fewer where there are no more.
std::vector<int> prerollFrames(const std::vector<int>& frames, int first, int count);

}  // namespace quell::cli
