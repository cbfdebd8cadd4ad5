// The quell tool as a function.
#pragma once

namespace quell::cli {

/// Parses the command line and runs the command. Returns the exit code: 0 success, 1 an error, in the command line too, that was
/// printed to standard error; 2 for what `quell check` calls wrong.
int runTool(int argc, const char* const* argv);

}  // namespace quell::cli
