// What --help says is all there is, and the documentation calls nothing that is not there.
#include <catch2/catch.hpp>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <quell/settings.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "host/cli/common/commands.hpp"
#include "host/cli/run_tool.hpp"
#include "host/io/atomic_file.hpp"

namespace quell::tests {
namespace {

using Names = std::set<std::string>;

// What the options of other programs are called by.
const std::regex kOtherPrograms("cmake|ctest|pkg-config|quell_bench|gpu_resources");

std::string printed(std::vector<const char*> argv) {
  argv.insert(argv.begin(), "quell");
  std::ostringstream text;
  std::streambuf* const before = std::cout.rdbuf(text.rdbuf());
  const int code = cli::runTool(static_cast<int>(argv.size()), argv.data());
  std::cout.rdbuf(before);
  CHECK(code == 0);
  return text.str();
}

std::string helpOf(const std::string& command) {
  return command.empty() ? printed({"--help"}) : printed({command.c_str(), "--help"});
}

Names found(const std::string& text, const std::regex& pattern) {
  Names names;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    names.insert((*match)[1]);
  return names;
}

// The first words of lines that are indented by this much, after a line that begins with the heading.
Names listed(const std::string& help, const std::string& heading, int indent) {
  const auto start = help.find("\n" + heading);
  if (start == std::string::npos) return {};
  return found(help.substr(start), std::regex("\n" + std::string(std::size_t(indent), ' ') + "([\\w-]+)"));
}

std::string between(const std::string& text, const std::string& first, const std::string& last) {
  const std::size_t found = text.find(first);
  if (found == std::string::npos) return "";
  const std::size_t begin = found + first.size();
  return text.substr(begin, text.find(last, begin) - begin);
}

// By command.
std::map<std::string, Names> optionsInHelp() {
  std::map<std::string, Names> options;
  for (const std::string& command : listed(helpOf(""), "Subcommands:", 2))
    options[command] = found(helpOf(command), std::regex("\n  (?:-\\w,)?(--[a-z][\\w-]*)"));
  return options;
}

}  // namespace

TEST_CASE("help lists every command", "[cli]") {
  CHECK(listed(helpOf(""), "Subcommands:", 2) ==
        Names{"bench", "check", "compare", "completion", "demo", "denoise", "devices", "f-beta", "kernels",
              "man", "render", "replay", "select-features", "settings", "stress", "tune", "tune-device"});
}

TEST_CASE("help lists every option, with a word on each", "[cli]") {
  CLI::App app;
  cli::addDenoiseCommand(app);
  cli::addCheckCommand(app);
  cli::addCompareCommand(app);
  cli::addBenchCommand(app);
  cli::addDemoCommand(app);
  cli::addDevicesCommand(app);
  cli::addFBetaCommand(app);
  cli::addKernelsCommand(app);
  cli::addManualCommands(app);
  cli::addSelectFeaturesCommand(app);
  cli::addStressCommand(app);
  cli::addRenderCommand(app);
  cli::addReplayCommand(app);
  cli::addTuneDeviceCommand(app);
  cli::addTuneCommand(app);
  const std::map<std::string, Names> shown = optionsInHelp();
  for (const CLI::App* command : app.get_subcommands({})) {
    INFO(command->get_name());
    CHECK_FALSE(command->get_description().empty());
    Names options;
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_lnames().empty()) continue;  // files without a name
      INFO(option->get_name());
      CHECK_FALSE(option->get_description().empty());
      options.insert("--" + option->get_lnames().front());
    }
    CHECK(shown.at(command->get_name()) == options);
  }
}

TEST_CASE("the manual page and completions have every option that help lists", "[cli]") {
  const std::string page = std::regex_replace(printed({"man"}), std::regex("\\\\-"), "-");
  const std::string bash = printed({"completion", "bash"}), zsh = printed({"completion", "zsh"});
  const std::string fish = printed({"completion", "fish"});
  for (const auto& [command, options] : optionsInHelp()) {
    INFO(command);
    const std::regex inPage("\n\\\\fB(?:-\\w, )?(--[a-z][\\w-]*)");
    CHECK(found(between(page, ".SS quell " + command + "\n", "\n.S"), inPage) == options);
    const std::string inBash = between(bash, "\n    " + command + ") options='", "'");
    CHECK(found(inBash, std::regex("(--[a-z][\\w-]*)")) == options);
    const std::string inZsh = between(zsh, "\n    " + command + ")\n", ";;");
    CHECK(found(inZsh, std::regex("'\\*(--[a-z][\\w-]*)\\[")) == options);
    Names inFish;
    const std::regex name("subcommand_from " + command + "' -l ([a-z][\\w-]*)");
    for (const std::string& option : found(fish, name)) inFish.insert("--" + option);
    CHECK(inFish == options);
  }
}

TEST_CASE("help lists every method with all of its settings", "[cli]") {
  for (const char* command : {"denoise", "bench", "tune"}) {
    const std::string help = helpOf(command);
    INFO(command);
    const std::vector<std::string> methods = methodNames();
    CHECK(listed(help, "Settings for", 2) == Names(methods.begin(), methods.end()));
    for (const std::string& method : methods) {
      INFO(method);
      const std::string own = help.substr(help.find("\n  " + method + ": ") + 1);
      std::smatch next;  // method
      const bool isLast = !std::regex_search(own, next, std::regex("\n  \\w"));
      Names names;
      for (const SettingDescription& setting : methodSettings(method)) names.insert(setting.name);
      CHECK(found(isLast ? own : own.substr(0, std::size_t(next.position())), std::regex("\n    (\\w+) ")) ==
            names);
    }
  }
}

TEST_CASE("the documentation names no option that the tool does not have", "[cli]") {
  const std::map<std::string, Names> options = optionsInHelp();
  Names all;
  for (const auto& [command, names] : options) all.insert(names.begin(), names.end());
  const std::string root = QUELL_DATA_DIR "/../";
  std::string text = io::readFile(root + "README.md");
  for (const auto& page : std::filesystem::directory_iterator(root + "docs"))
    if (page.path().extension() == ".md") text += io::readFile(page.path().string());
  text = std::regex_replace(text, std::regex("\\\\\n"), " ");
  text = std::regex_replace(text, std::regex("  +# .*"), "");  // what a call is followed by
  std::istringstream lines(text);
  int calls = 0;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_search(line, kOtherPrograms)) continue;
    INFO(line);
    const Names used = found(line, std::regex("[ `(](--[a-z][\\w-]*)"));
    std::smatch call;
    const bool isCall = std::regex_search(line, call, std::regex("^quell ([a-z-]+)"));
    if (isCall) ++calls;
    const Names& known = isCall ? options.at(call[1]) : all;
    for (const std::string& option : used) {
      INFO(option);
      CHECK(known.count(option) == 1);
    }
  }
  CHECK(calls > 10);
}

}  // namespace quell::tests
