#include "host/cli/manual/option_table.hpp"

#include <algorithm>
#include <quell/settings.hpp>
#include <set>
#include <sstream>

namespace quell::cli {
namespace {

/// "TEXT:{on,off}" as its choices.
std::vector<std::string> choicesOf(const std::string& type) {
  const std::size_t begin = type.find('{'), end = type.rfind('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  std::vector<std::string> choices;
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for (std::string choice; std::getline(list, choice, ',');) choices.push_back(choice);
  return choices;
}

/// What precedes the value in --set and --vary.
std::vector<std::string> settingPrefixes() {
  std::set<std::string> names;
  for (const std::string& method : methodNames())
    for (const SettingDescription& setting : methodSettings(method)) names.insert(setting.name + "=");
  return {names.begin(), names.end()};
}

/// "TEXT:{on,off}" as "TEXT", "INT:POSITIVE" as "INT", "FLOAT:FLOAT in [0 - 1]" as "FLOAT in [0 - 1]".
std::string valueOf(const std::string& type) {
  const std::size_t colon = type.find(':');
  if (colon == std::string::npos) return type;
  const bool saysMore = type.find('{') == std::string::npos && type.find(' ') != std::string::npos;
  return saysMore ? type.substr(colon + 1) : type.substr(0, colon);
}

OptionText describe(const CLI::Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (text.names.empty()) text.names.push_back(option.get_name(true));
  const std::string type = option.get_type_name();
  if (option.get_items_expected_max() > 0) text.value = valueOf(type);
  text.choices = choicesOf(type);
  if (text.names.back() == "--set" || text.names.back() == "--vary") text.choices = settingPrefixes();
  text.defaultValue = option.get_default_str();
  text.description = option.get_description();
  text.required = option.get_required();
  return text;
}

}  // namespace

std::vector<CommandText> describeCommands(const CLI::App& app) {
  std::vector<CommandText> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back({command->get_name(), command->get_description(), {}, {}, command->get_footer()});
    for (const CLI::Option* option : command->get_options()) {
      CommandText& text = commands.back();
      (option->get_positional() ? text.arguments : text.options).push_back(describe(*option));
    }
  }
  return commands;
}

}  // namespace quell::cli
