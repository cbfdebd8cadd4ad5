// The tool's commands and options as data: what manual page and completions are made of. It is read from the same
// objects that parse the command line and print --help.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace quell::cli {

struct OptionText {
  std::vector<std::string> names;  ///< "--input", or "-h" and "--help"; of arguments without a dash "images"
  std::string value;               ///< what it takes: "TEXT", "FLOAT in [0 - 1]"; empty: nothing
  std::vector<std::string> choices;  ///< of values, if there are only so many
  std::string defaultValue;
  std::string description;
  bool required = false;
};

struct CommandText {
  std::string name;
  std::string description;
  std::vector<OptionText> arguments;  ///< without a name, in their order
  std::vector<OptionText> options;
  std::string footer;  ///< several lines, as --help shows them
};

/// All commands of the tool, as they were added.
std::vector<CommandText> describeCommands(const CLI::App& app);

}  // namespace quell::cli
