// A denoising method: a name, its settings, and a function that lays out its table of stages.
#pragma once

#include <functional>
#include <quell/settings.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/core/schedule.hpp"
#include "host/methods/setting_table.hpp"
#include "host/stages/import_image.hpp"

namespace quell {

struct Method {
  std::string name;
  std::string summary;  ///< one line
  std::vector<SettingDescription> settings;
  std::function<Schedule(const Configuration&)> makeSchedule;
  std::function<RuntimeSettings(const Settings&)> runtimeSettings;
  /// Throws Error(OutOfRange) unless this text suits this setting, whose kind is Text.
  std::function<void(const std::string& setting, const std::string& text)> checkText;
};

/// A method with the settings of `table`. `makeSchedule` sees their values as a struct; the runtime is told what
/// runtimeSettings() makes of that.
template <class Values>
Method makeMethod(const std::string& name, const std::string& summary, const SettingTable<Values>& table,
                  Schedule (*makeSchedule)(const Configuration&, const Values&)) {
  return {name,
          summary,
          table.descriptions(),
          [table, makeSchedule](const Configuration& configuration) {
            Schedule schedule = makeSchedule(configuration, table.resolve(configuration.settings));
            addImports(schedule, configuration);
            return schedule;
          },
          [table](const Settings& settings) { return runtimeSettings(table.resolve(settings)); },
          [table](const std::string& setting, const std::string& text) { table.checkText(setting, text); }};
}

/// All methods; a line of registry.cpp each.
const std::vector<Method>& methods();

/// Throws Error(UnknownSetting) listing the names there are.
const Method& findMethod(const std::string& name);

}  // namespace quell
