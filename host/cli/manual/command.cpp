// quell man, quell completion, quell settings: pages that follow from the tool itself.
#include <quell/quell.h>

#include <iostream>
#include <memory>

#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/commands.hpp"
#include "host/cli/manual/pages.hpp"

namespace quell::cli {
namespace {

std::string completionFor(const std::string& shell, const std::vector<CommandText>& commands) {
  if (shell == "bash") return bashCompletion(commands);
  if (shell == "fish") return fishCompletion(commands);
  if (shell == "zsh") return zshCompletion(commands);
  refuse("completion", "shell", "bash, fish or zsh", shell);
}

}  // namespace

void addManualCommands(CLI::App& app) {
  app.add_subcommand("man", "Print the manual page, in the macros of man(7)")->callback([&app] {
    std::cout << manualPage(describeCommands(app), quellVersion());
  });
  app.add_subcommand("settings", "Print the settings of all methods as a table, in Markdown")->callback([] {
    std::cout << settingsPage();
  });
  const auto shell = std::make_shared<std::string>();
  CLI::App* completion = app.add_subcommand("completion", "Print the completion for a shell");
  completion->add_option("shell", *shell, "bash, fish or zsh")->required();
  completion->callback([&app, shell] { std::cout << completionFor(*shell, describeCommands(app)); });
}

}  // namespace quell::cli
