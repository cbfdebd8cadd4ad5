#include <algorithm>
#include <cctype>
#include <cmath>
#include <quell/error.hpp>
#include <quell/settings.hpp>

#include "host/core/number_text.hpp"
#include "host/methods/method.hpp"

namespace quell {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Letters to insert, remove or replace between two words, whatever their case (Levenshtein distance).
std::size_t lettersApart(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = std::tolower(static_cast<unsigned char>(a[i - 1])) ==
                        std::tolower(static_cast<unsigned char>(b[j - 1]));
      const std::size_t replaced = diagonal + (same ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

/// What was meant by a name that is mistyped; empty where no name is near.
std::string nearestName(const std::string& name, const std::vector<std::string>& names) {
  std::size_t least = name.size() / 3 + 1;
  std::string nearest;
  for (const std::string& candidate : names) {
    const std::size_t apart = lettersApart(name, candidate);
    if (apart >= least) continue;
    least = apart;
    nearest = candidate;
  }
  return nearest;
}

[[noreturn]] void refuse(const SettingDescription& setting, const std::string& got) {
  std::string expected;
  if (setting.kind == SettingKind::Boolean) {
    expected = "on or off";
  } else if (setting.kind == SettingKind::Choice) {
    expected = "one of " + joined(setting.choices);
  } else if (setting.kind == SettingKind::Text) {
    expected = "a text";
  } else {
    expected = std::string(setting.kind == SettingKind::Integer ? "a whole number" : "a number") + " from " +
               numberText(setting.minimum) + " to " + numberText(setting.maximum);
    if (!setting.unit.empty()) expected += " " + setting.unit;
  }
  throw Error(ErrorCode::OutOfRange, {"settings", setting.name, expected, got});
}

}  // namespace

Settings::Settings(const std::string& method) : m_method(method) {
  for (const SettingDescription& setting : methodSettings(method))
    m_values.push_back({setting.defaultValue, setting.defaultText});
}

const std::vector<SettingDescription>& Settings::descriptions() const { return methodSettings(m_method); }

std::size_t Settings::indexOf(const std::string& name) const {
  std::vector<std::string> names;
  for (const SettingDescription& setting : descriptions()) {
    if (setting.name == name) return names.size();
    names.push_back(setting.name);
  }
  const std::string nearest = nearestName(name, names);
  throw Error(ErrorCode::UnknownSetting, {"settings", name,
                                          (nearest.empty() ? "" : "perhaps " + nearest + "; ") +
                                              "a setting of " + m_method + ": " + joined(names),
                                          name});
}

void Settings::set(const std::string& name, double value) {
  const std::size_t index = indexOf(name);
  const SettingDescription& setting = descriptions()[index];
  if (setting.kind == SettingKind::Text) refuse(setting, numberText(value));
  const bool whole = setting.kind == SettingKind::Real || value == std::floor(value);
  if (!(value >= setting.minimum && value <= setting.maximum) || !whole) refuse(setting, numberText(value));
  m_values[index].number = value;
}

void Settings::set(const std::string& name, const std::string& text) {
  const std::size_t index = indexOf(name);
  const SettingDescription& setting = descriptions()[index];
  if (setting.kind == SettingKind::Text) {
    findMethod(m_method).checkText(name, text);
    m_values[index].text = text;
    return;
  }
  if (setting.kind == SettingKind::Boolean && (text == "on" || text == "true")) return set(name, 1.0);
  if (setting.kind == SettingKind::Boolean && (text == "off" || text == "false")) return set(name, 0.0);
  if (setting.kind == SettingKind::Choice) {
    const auto found = std::find(setting.choices.begin(), setting.choices.end(), text);
    if (found == setting.choices.end()) refuse(setting, text);
    return set(name, static_cast<double>(found - setting.choices.begin()));
  }
  double value = 0.0;
  if (!parseNumber(text, value)) refuse(setting, text.empty() ? "nothing" : text);
  set(name, value);
}

void Settings::usePreset(const std::string& preset) {
  if (preset != "default" && preset != "paper")
    throw Error(ErrorCode::UnknownSetting, {"settings", "preset", "default or paper", preset});
  for (std::size_t i = 0; i < m_values.size(); ++i) {
    const SettingDescription& setting = descriptions()[i];
    if (preset == "default") m_values[i] = {setting.defaultValue, setting.defaultText};
    if (preset == "paper" && setting.paper) m_values[i].number = *setting.paper;
  }
}

double Settings::get(const std::string& name) const { return m_values[indexOf(name)].number; }

bool Settings::isOn(const std::string& name) const { return get(name) != 0.0; }

std::string Settings::text(const std::string& name) const {
  const std::size_t index = indexOf(name);
  const SettingDescription& setting = descriptions()[index];
  if (setting.kind == SettingKind::Boolean) return m_values[index].number != 0.0 ? "on" : "off";
  if (setting.kind == SettingKind::Choice)
    return setting.choices[static_cast<std::size_t>(m_values[index].number)];
  if (setting.kind == SettingKind::Text) return m_values[index].text;
  return numberText(m_values[index].number);
}

}  // namespace quell
