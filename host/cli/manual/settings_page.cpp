#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <quell/settings.hpp>

#include "host/cli/common/command_arguments.hpp"
#include "host/cli/manual/pages.hpp"

namespace quell::cli {
namespace {

/// A line of the table: all methods for which it reads alike.
struct Row {
  std::string name, text;
  std::vector<std::string> methods;
};

std::string textOf(const SettingDescription& setting, const std::string& defaultValue) {
  return fmt::format("{} | {} | {} | {} |", defaultValue, settingRange(setting), setting.description,
                     setting.source);
}

void addTo(std::vector<Row>& rows, const std::string& method, const std::string& name,
           const std::string& text) {
  const auto same = std::find_if(rows.begin(), rows.end(),
                                 [&](const Row& row) { return row.name == name && row.text == text; });
  if (same != rows.end()) {
    same->methods.push_back(method);
    return;
  }
  // Beside the other rows of that name, so that differences between methods are seen.
  const auto last =
      std::find_if(rows.rbegin(), rows.rend(), [&](const Row& row) { return row.name == name; });
  rows.insert(last == rows.rend() ? rows.end() : last.base(), {name, text, {method}});
}

}  // namespace

std::string settingsPage() {
  const std::vector<std::string> methods = methodNames();
  std::vector<Row> rows;
  for (const std::string& method : methods) {
    const Settings defaults(method);
    for (const SettingDescription& setting : methodSettings(method))
      addTo(rows, method, setting.name, textOf(setting, defaults.text(setting.name)));
  }
  std::string page =
      "# Settings\n\nAll settings of all methods, as `quell settings` prints them: `Settings::set(name, "
      "value)`, "
      "`--set name=value`, `bench --vary`,\n`tune --vary`. Which need `prepare()`: "
      "`Denoiser::settingsToPrepare()`.\n\n"
      "| setting | of | default | values | what it is | source |\n|---|---|---|---|---|---|\n";
  for (const Row& row : rows)
    page += fmt::format("| `{}` | {} | {}\n", row.name,
                        row.methods == methods ? "all" : fmt::format("{}", fmt::join(row.methods, ", ")),
                        row.text);
  return page;
}

}  // namespace quell::cli
