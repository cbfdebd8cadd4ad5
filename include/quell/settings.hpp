// Methods and their settings, by name: one list serves C++ callers, command lines, files and documentation.
#pragma once

#include <quell/api.h>

#include <optional>
#include <string>
#include <vector>

namespace quell {

/// Which values a setting takes.
enum class SettingKind {
  Real,     ///< numbers from `minimum` to `maximum`
  Integer,  ///< whole numbers from `minimum` to `maximum`
  Boolean,  ///< 0 or 1, off or on
  Choice,   ///< one of `choices`, or its index
  Text,     ///< in a form that `description` explains; has no number
};

/// What a setting means and which values it takes.
struct SettingDescription {
  std::string name;                      ///< unique within its method
  SettingKind kind = SettingKind::Real;  ///< which values it takes
  double defaultValue = 0.0;             ///< for Choice: index into `choices`; for Boolean: 0 or 1
  double minimum = 0.0;                  ///< smallest accepted value
  double maximum = 0.0;                  ///< largest accepted value
  std::string unit;                      ///< empty: a plain number
  std::string description;               ///< what it does, in half a sentence
  std::string source;                    ///< paper and section, or how the default was found
  std::vector<std::string> choices;      ///< for Choice only
  std::string defaultText = "";          ///< for Text only
  std::optional<double> paper = {};      ///< the value of the method's paper, where the default may differ
};

/// Values of the settings of one method; starts at the defaults.
class QUELL_API Settings {
 public:
  /// Throws Error(UnknownSetting) for an unknown method; methodNames() lists them.
  explicit Settings(const std::string& method = "quell");

  /// The method's name.
  const std::string& method() const { return m_method; }

  /// Throws Error(UnknownSetting) for an unknown name and Error(OutOfRange) for a value that is out of range,
  /// not finite, or not a whole number where one is needed, or for a setting of kind Text.
  void set(const std::string& name, double value);
  /// Accepts numbers, on/off/true/false for switches, the names of choices, and texts. Throws as above.
  void set(const std::string& name, const std::string& text);

  /// Sets what `preset` has a value for: "default" everything; "paper" what the method's paper says where the default
  /// is something else (svgf, bmfr; the others stay as they are). Throws Error(UnknownSetting) for another name.
  void usePreset(const std::string& preset);

  double get(const std::string& name) const;        ///< throws Error(UnknownSetting); 0 for Text
  bool isOn(const std::string& name) const;         ///< get() != 0
  std::string text(const std::string& name) const;  ///< the value as set(name, text) takes it
  /// methodSettings() of the method.
  const std::vector<SettingDescription>& descriptions() const;

 private:
  std::size_t indexOf(const std::string& name) const;

  std::string m_method;
  struct Value {
    double number = 0.0;
    std::string text;  // for Text only
  };
  std::vector<Value> m_values;  // in the order of descriptions()
};

/// All methods, the default one first.
QUELL_API std::vector<std::string> methodNames();
/// One line on what a method does. Throws Error(UnknownSetting).
QUELL_API std::string methodSummary(const std::string& method);
/// All settings of a method, as the manual lists them; lives as long as the program. Throws Error(UnknownSetting).
QUELL_API const std::vector<SettingDescription>& methodSettings(const std::string& method);

}  // namespace quell
