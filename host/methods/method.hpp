// A denoising method: a name, its settings, and a function that lays out its table of stages.
#pragma once

#include <functional>
#include <quell/settings.hpp>
#include <string>
#include <vector>

#include "host/core/reprojection.hpp"
#include "host/core/schedule.hpp"

namespace quell {

struct Method {
  std::string name;
  std::string summary;  ///< one line
  std::vector<SettingDescription> settings;
  std::function<Schedule(const Configuration&)> makeSchedule;
  std::function<DiscardLimits(const Settings&)> discardLimits;
  /// Throws Error(OutOfRange) unless this text suits this setting, whose kind is Text; absent where a method
  /// has no such setting.
  std::function<void(const std::string& setting, const std::string& text)> checkText = {};
};

/// All methods. A new one is added in registry.cpp and nowhere else.
const std::vector<Method>& methods();

/// Throws Error(UnknownSetting) listing the names there are.
const Method& findMethod(const std::string& name);

}  // namespace quell
