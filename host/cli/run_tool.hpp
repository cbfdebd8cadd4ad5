// The quell tool as a function.
#pragma once

namespace quell::cli {

/// Parses the command line and runs the command. Returns the exit code: 0 success, 1 an error that was
/// printed to standard error, CLI11's codes (100 and up) for usage errors.
int runTool(int argc, const char* const* argv);

}  // namespace quell::cli
