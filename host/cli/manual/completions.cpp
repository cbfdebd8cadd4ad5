#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/cli/manual/pages.hpp"

namespace quell::cli {
namespace {

/// For quotes of a shell; descriptions are cut to one line.
std::string quotable(const std::string& text) {
  std::string result;
  for (const char character : text.substr(0, text.find('\n')))
    if (character != '\'' && character != '\\') result += character;
  return result;
}

std::string words(const std::vector<std::string>& list) { return fmt::format("{}", fmt::join(list, " ")); }

std::string namesOf(const std::vector<CommandText>& commands) {
  std::vector<std::string> names;
  for (const CommandText& command : commands) names.push_back(command.name);
  return words(names);
}

std::string namesOf(const std::vector<OptionText>& options) {
  std::vector<std::string> names;
  for (const OptionText& option : options) names.push_back(option.names.back());
  return words(names);
}

/// One line that completes an option of fish: by its long name, with choices, or files where it takes a value.
std::string fishOption(const std::string& command, const OptionText& option) {
  std::string takes;
  if (!option.choices.empty()) {
    takes = fmt::format(" -x -a '{}'", words(option.choices));
  } else if (!option.value.empty()) {
    takes = " -r";
  }
  return fmt::format("complete -c quell -n '__fish_seen_subcommand_from {}' -l {}{} -d '{}'\n", command,
                     option.names.back().substr(2), takes, quotable(option.description));
}

/// One argument of _arguments, in single quotes: brackets and colons end descriptions.
std::string zshOption(const OptionText& option) {
  std::string description;
  for (const char character : quotable(option.description)) {
    if (character == '[' || character == ']' || character == ':') description += '\\';
    description += character;
  }
  std::string takes;
  if (!option.choices.empty()) {
    takes = fmt::format(":value:({})", words(option.choices));
  } else if (!option.value.empty()) {
    takes = ":value:_files";
  }
  return fmt::format(" \\\n        '*{}[{}]{}'", option.names.back(), description, takes);
}

}  // namespace

std::string bashCompletion(const std::vector<CommandText>& commands) {
  std::string choices, options;
  for (const CommandText& command : commands) {
    for (const OptionText& option : command.options)
      if (!option.choices.empty())
        choices += fmt::format("    '{} {}') words='{}' ;;\n", command.name, option.names.back(),
                               words(option.choices));
    options += fmt::format("    {}) options='{}' ;;\n", command.name, namesOf(command.options));
  }
  return fmt::format(R"(# Completion of quell for bash.
_quell() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} words= options=
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W '{} --help --version' -- "$current"))
    return
  fi
  case "${{COMP_WORDS[1]}} $before" in
{}  esac
  case "${{COMP_WORDS[1]}}" in
{}  esac
  case "$current" in -*) [ -n "$words" ] || words=$options ;; esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
  case "${{COMPREPLY[0]}}" in *=) compopt -o nospace ;; esac
}}
complete -o default -F _quell quell
)",
                     namesOf(commands), choices, options);
}

std::string fishCompletion(const std::vector<CommandText>& commands) {
  std::string text = "# Completion of quell for fish.\n";
  for (const CommandText& command : commands) {
    text += fmt::format("complete -c quell -n __fish_use_subcommand -x -a {} -d '{}'\n", command.name,
                        quotable(command.description));
    for (const OptionText& option : command.options) text += fishOption(command.name, option);
  }
  return text;
}

std::string zshCompletion(const std::vector<CommandText>& commands) {
  std::string list, cases;
  for (const CommandText& command : commands) {
    list += fmt::format("    '{}:{}'\n", command.name, quotable(command.description));
    cases += fmt::format("    {})\n      _arguments", command.name);
    for (const OptionText& option : command.options) cases += zshOption(option);
    cases += " \\\n        '*:file:_files' ;;\n";
  }
  return fmt::format(R"(#compdef quell
_quell() {{
  local -a commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  shift words
  (( CURRENT-- ))
  case $words[1] in
{}  esac
}}
_quell "$@"
)",
                     list, cases);
}

}  // namespace quell::cli
