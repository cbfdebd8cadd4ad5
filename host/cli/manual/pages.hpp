// The manual page and completions of shells, as text.
#pragma once

#include <string>
#include <vector>

#include "host/cli/manual/option_table.hpp"

namespace quell::cli {

/// quell(1) in the macros of man(7).
std::string manualPage(const std::vector<CommandText>& commands, const std::string& version);

/// To be sourced, or put where the shell looks for completions. Completes commands, options and choices, and files elsewhere.
std::string bashCompletion(const std::vector<CommandText>& commands);
std::string fishCompletion(const std::vector<CommandText>& commands);
/// Begins with #compdef, as files of zsh's fpath do.
std::string zshCompletion(const std::vector<CommandText>& commands);

/// docs/settings.md: the settings of all methods in a table, in Markdown.
std::string settingsPage();

}  // namespace quell::cli
