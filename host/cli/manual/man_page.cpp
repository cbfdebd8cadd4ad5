#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/cli/manual/pages.hpp"

namespace quell::cli {
namespace {

/// Text that is not taken for requests, and whose dashes may be pasted into a shell.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char character : text) {
    const bool begins = result.empty() || result.back() == '\n';
    if (begins && (character == '.' || character == '\'')) result += "\\&";
    if (character == '\\') {
      result += "\\e";
    } else if (character == '-') {
      result += "\\-";
    } else {
      result += character;
    }
  }
  return result;
}

std::string entry(const OptionText& option) {
  std::string text =
      fmt::format(".TP\n\\fB{}\\fR", escaped(fmt::format("{}", fmt::join(option.names, ", "))));
  if (!option.value.empty()) text += fmt::format(" \\fI{}\\fR", escaped(option.value));
  text += fmt::format("\n{}", escaped(option.description));
  // Of --set and --vary the names are listed below, with a line on each.
  const bool isPrefix = !option.choices.empty() && option.choices.front().back() == '=';
  if (!option.choices.empty() && !isPrefix)
    text += fmt::format("; one of {}", escaped(fmt::format("{}", fmt::join(option.choices, ", "))));
  if (!option.defaultValue.empty()) text += fmt::format(" (default {})", escaped(option.defaultValue));
  if (option.required) text += " (required)";
  return text + "\n";
}

std::string section(const CommandText& command) {
  std::string text = fmt::format(".SS quell {}\n{}.\n", escaped(command.name), escaped(command.description));
  for (const OptionText& argument : command.arguments) text += entry(argument);
  for (const OptionText& option : command.options) text += entry(option);
  if (!command.footer.empty()) text += fmt::format(".PP\n.nf\n{}\n.fi\n", escaped(command.footer));
  return text;
}

constexpr const char* kIntroduction = R"(.SH NAME
quell \- denoise path\-traced frame sequences on any OpenCL device
.SH SYNOPSIS
.B quell
.I command
.RI [ options ]
.SH DESCRIPTION
Quell removes the noise from real\-time path tracing.
The tool denoises frame sequences on disk, says what is odd about them, measures errors against references and times every
stage.
)";

constexpr const char* kEnd = R"(.SH EXIT STATUS
0 on success, 1 after an error, which is said on standard error; of check see there.
.SH ENVIRONMENT
.TP
.B XDG_CACHE_HOME
Compiled kernels are kept in its folder quell, by default in ~/.cache/quell.
)";

}  // namespace

std::string manualPage(const std::vector<CommandText>& commands, const std::string& version) {
  std::string text = fmt::format(".TH QUELL 1 \"\" \"quell {}\"\n{}.SH COMMANDS\n", version, kIntroduction);
  for (const CommandText& command : commands) text += section(command);
  return text + kEnd;
}

}  // namespace quell::cli
