// Settings as a plain struct: one call a setting binds a member to its name, default, range, meaning and source. From
// that follow what the public interface tells about the setting, and the struct itself for given values.
#pragma once

#include <functional>
#include <optional>
#include <quell/settings.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace quell {

/// Accepted values, both ends included.
struct SettingRange {
  double minimum = 0.0;
  double maximum = 0.0;
  const char* unit = "";  ///< empty: a plain number
};

/// The name of a choice. Beside every enum that is a setting stands its choiceNames(), in the enumerators' order.
template <class Choice>
const char* choiceName(Choice choice) {
  return choiceNames(choice)[static_cast<std::size_t>(choice)];
}

/// The settings that are members of `Struct`, in the order in which users see them. The kind of a setting is the
/// member's type: double, int, bool, an enum with choiceNames(), or a class that is made of a text.
template <class Struct>
class SettingTable {
 public:
  struct Row {
    SettingDescription description;
    std::function<void(Struct&, const Settings&)> resolve;
    std::function<void(const std::string&)> checkText = {};  ///< for kind Text only

    /// What the method's paper says, which usePreset("paper") sets. Without it the preset leaves the setting alone.
    void paper(std::optional<double> value) { description.paper = value; }
    template <class Choice, std::enable_if_t<std::is_enum_v<Choice>, int> = 0>
    void paper(Choice value) {
      description.paper = static_cast<double>(value);
    }
  };

  Row& add(const char* name, double Struct::*member, double byDefault, const SettingRange& range,
           const char* description, const char* source) {
    return addNumber(name, SettingKind::Real, member, byDefault, range, description, source);
  }
  Row& add(const char* name, int Struct::*member, int byDefault, const SettingRange& range,
           const char* description, const char* source) {
    return addNumber(name, SettingKind::Integer, member, byDefault, range, description, source);
  }
  Row& add(const char* name, bool Struct::*member, bool byDefault, const char* description,
           const char* source) {
    return addNumber(name, SettingKind::Boolean, member, byDefault, {0.0, 1.0}, description, source);
  }

  template <class Choice, std::enable_if_t<std::is_enum_v<Choice>, int> = 0>
  Row& add(const char* name, Choice Struct::*member, Choice byDefault, const char* description,
           const char* source) {
    const auto names = choiceNames(byDefault);
    const SettingRange range{0.0, static_cast<double>(names.size() - 1)};
    Row& row = addNumber(name, SettingKind::Choice, member, byDefault, range, description, source);
    row.description.choices.assign(names.begin(), names.end());
    return row;
  }

  /// A text that the member is made of; what its constructor throws is what set() throws.
  template <class Value, std::enable_if_t<std::is_constructible_v<Value, std::string>, int> = 0>
  Row& add(const char* name, Value Struct::*member, const char* byDefault, const char* description,
           const char* source) {
    Row& row = push(name, SettingKind::Text, 0.0, {}, description, source,
                    [name, member](Struct& values, const Settings& settings) {
                      values.*member = Value(settings.text(name));
                    });
    row.description.defaultText = byDefault;
    row.checkText = [](const std::string& text) { static_cast<void>(Value(text)); };
    return row;
  }

  /// A choice of a few numbers; the first one is the default.
  Row& addOneOf(const char* name, int Struct::*member, const std::vector<int>& numbers, const char* unit,
                const char* description, const char* source) {
    const SettingRange range{0.0, static_cast<double>(numbers.size() - 1), unit};
    Row& row = push(name, SettingKind::Choice, 0.0, range, description, source,
                    [name, member, numbers](Struct& values, const Settings& settings) {
                      values.*member = numbers[static_cast<std::size_t>(settings.get(name))];
                    });
    for (const int number : numbers) row.description.choices.push_back(std::to_string(number));
    return row;
  }

  /// All settings of a part of the struct.
  template <class Part>
  void include(Part Struct::*member, const SettingTable<Part>& part) {
    for (const auto& row : part.rows()) {
      const auto resolve = [member, resolvePart = row.resolve](Struct& values, const Settings& settings) {
        resolvePart(values.*member, settings);
      };
      m_rows.push_back({row.description, resolve, row.checkText});
    }
  }

  const std::vector<Row>& rows() const { return m_rows; }

  std::vector<SettingDescription> descriptions() const {
    std::vector<SettingDescription> all;
    for (const Row& row : m_rows) all.push_back(row.description);
    return all;
  }

  /// The struct of these values. Throws Error(UnknownSetting) if they are another method's.
  Struct resolve(const Settings& settings) const {
    Struct values{};
    for (const Row& row : m_rows) row.resolve(values, settings);
    return values;
  }

  /// Throws Error(OutOfRange) unless this text suits this setting.
  void checkText(const std::string& name, const std::string& text) const {
    for (const Row& row : m_rows)
      if (row.description.name == name && row.checkText) row.checkText(text);
  }

 private:
  using Resolve = std::function<void(Struct&, const Settings&)>;

  template <class Value>
  Row& addNumber(const char* name, SettingKind kind, Value Struct::*member, Value byDefault,
                 const SettingRange& range, const char* description, const char* source) {
    return push(name, kind, static_cast<double>(byDefault), range, description, source,
                [name, member](Struct& values, const Settings& settings) {
                  values.*member = static_cast<Value>(settings.get(name));
                });
  }

  Row& push(const char* name, SettingKind kind, double byDefault, const SettingRange& range,
            const char* description, const char* source, Resolve resolve) {
    SettingDescription all = {name,        kind,   byDefault, range.minimum, range.maximum, range.unit,
                              description, source, {}};
    m_rows.push_back({std::move(all), std::move(resolve)});
    return m_rows.back();
  }

  std::vector<Row> m_rows;
};

}  // namespace quell
