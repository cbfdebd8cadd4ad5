#include <memory>
#include <vector>

#include "host/c_api/boundary.hpp"
#include "host/c_api/handles.hpp"
#include "host/methods/method.hpp"

namespace quell::c_api {
namespace {

quell_setting_kind toC(SettingKind kind) {
  switch (kind) {
    case SettingKind::Real:
      return QUELL_SETTING_REAL;
    case SettingKind::Integer:
      return QUELL_SETTING_INTEGER;
    case SettingKind::Boolean:
      return QUELL_SETTING_BOOLEAN;
    case SettingKind::Choice:
      return QUELL_SETTING_CHOICE;
    case SettingKind::Text:
      break;
  }
  return QUELL_SETTING_TEXT;
}

quell_setting_info toC(const SettingDescription& setting) {
  return {0,
          setting.name.c_str(),
          toC(setting.kind),
          setting.defaultValue,
          setting.minimum,
          setting.maximum,
          setting.unit.c_str(),
          setting.description.c_str(),
          setting.source.c_str(),
          setting.defaultText.c_str(),
          setting.choices.size(),
          setting.paper ? 1 : 0,
          setting.paper.value_or(0.0)};
}

const SettingDescription& describe(const char* method, size_t index, const char* function) {
  require(method, function, "method");
  const std::vector<SettingDescription>& settings = methodSettings(method);
  requireIndex(index, settings.size(), function, "index");
  return settings[index];
}

}  // namespace
}  // namespace quell::c_api

using namespace quell::c_api;

extern "C" {

quell_status quellCountMethods(size_t* count) {
  return guarded("quellCountMethods", [&] {
    require(count, "quellCountMethods", "count");
    *count = quell::methods().size();
  });
}

quell_status quellGetMethod(size_t index, quell_method_info* info) {
  return guarded("quellGetMethod", [&] {
    requireIndex(index, quell::methods().size(), "quellGetMethod", "index");
    const quell::Method& method = quell::methods()[index];
    writeStruct(info, {0, method.name.c_str(), method.summary.c_str(), method.settings.size()},
                "quellGetMethod", "info");
  });
}

quell_status quellGetSettingInfo(const char* method, size_t index, quell_setting_info* info) {
  return guarded("quellGetSettingInfo", [&] {
    writeStruct(info, toC(describe(method, index, "quellGetSettingInfo")), "quellGetSettingInfo", "info");
  });
}

quell_status quellGetSettingChoice(const char* method, size_t index, size_t choice, const char** name) {
  return guarded("quellGetSettingChoice", [&] {
    const quell::SettingDescription& setting = describe(method, index, "quellGetSettingChoice");
    requireIndex(choice, setting.choices.size(), "quellGetSettingChoice", "choice");
    require(name, "quellGetSettingChoice", "name");
    *name = setting.choices[choice].c_str();
  });
}

quell_status quellCreateSettings(const char* method, quell_settings** settings) {
  return guarded("quellCreateSettings", [&] {
    require(settings, "quellCreateSettings", "settings");
    quell::Settings values = method == nullptr ? quell::Settings() : quell::Settings(method);
    *settings = new quell_settings{std::move(values), {}, {}};
  });
}

void quellDestroySettings(quell_settings* settings) { delete settings; }

quell_status quellSetSetting(quell_settings* settings, const char* name, const char* value) {
  return guarded("quellSetSetting", [&] {
    require(settings, "quellSetSetting", "settings");
    require(name, "quellSetSetting", "name");
    require(value, "quellSetSetting", "value");
    settings->settings.set(name, std::string(value));
  });
}

quell_status quellSetSettingNumber(quell_settings* settings, const char* name, double value) {
  return guarded("quellSetSettingNumber", [&] {
    require(settings, "quellSetSettingNumber", "settings");
    require(name, "quellSetSettingNumber", "name");
    settings->settings.set(name, value);
  });
}

quell_status quellUsePreset(quell_settings* settings, const char* preset) {
  return guarded("quellUsePreset", [&] {
    require(settings, "quellUsePreset", "settings");
    require(preset, "quellUsePreset", "preset");
    settings->settings.usePreset(preset);
  });
}

quell_status quellGetSetting(quell_settings* settings, const char* name, const char** value) {
  return guarded("quellGetSetting", [&] {
    require(settings, "quellGetSetting", "settings");
    require(name, "quellGetSetting", "name");
    require(value, "quellGetSetting", "value");
    settings->text = settings->settings.text(name);
    *value = settings->text.c_str();
  });
}

quell_status quellGetSettingNumber(const quell_settings* settings, const char* name, double* value) {
  return guarded("quellGetSettingNumber", [&] {
    require(settings, "quellGetSettingNumber", "settings");
    require(name, "quellGetSettingNumber", "name");
    require(value, "quellGetSettingNumber", "value");
    *value = settings->settings.get(name);
  });
}

quell_status quellCountInputNeeds(quell_settings* settings, size_t* count) {
  return guarded("quellCountInputNeeds", [&] {
    require(settings, "quellCountInputNeeds", "settings");
    require(count, "quellCountInputNeeds", "count");
    settings->needs = quell::inputNeeds(settings->settings);
    *count = settings->needs.size();
  });
}

quell_status quellGetInputNeed(const quell_settings* settings, size_t index, quell_input_need* need) {
  return guarded("quellGetInputNeed", [&] {
    require(settings, "quellGetInputNeed", "settings");
    requireIndex(index, settings->needs.size(), "quellGetInputNeed", "index");
    const quell::InputNeed& found = settings->needs[index];
    writeStruct(need,
                {0, found.image.c_str(), static_cast<quell_input_use>(found.use), found.without.c_str()},
                "quellGetInputNeed", "need");
  });
}

quell_status quellGetSettingsMethod(const quell_settings* settings, const char** method) {
  return guarded("quellGetSettingsMethod", [&] {
    require(settings, "quellGetSettingsMethod", "settings");
    require(method, "quellGetSettingsMethod", "method");
    *method = settings->settings.method().c_str();
  });
}

}  // extern "C"
