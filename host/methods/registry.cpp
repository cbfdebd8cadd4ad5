#include <quell/error.hpp>

#include "host/methods/method.hpp"

// All methods, in the order in which users see them; the first is the default. METHOD(name) stands for the function
// name##Method() of host/methods/<name>.cpp.
#define QUELL_METHODS(METHOD) \
  METHOD(quell)               \
  METHOD(bmfr)                \
  METHOD(svgf)                \
  METHOD(edagi)               \
  METHOD(guided)              \
  METHOD(atrous)

namespace quell {

#define QUELL_DECLARE_METHOD(name) Method name##Method();
QUELL_METHODS(QUELL_DECLARE_METHOD)

const std::vector<Method>& methods() {
#define QUELL_MAKE_METHOD(name) name##Method(),
  static const std::vector<Method> all = {QUELL_METHODS(QUELL_MAKE_METHOD)};
  return all;
}

const Method& findMethod(const std::string& name) {
  std::string names;
  for (const Method& method : methods()) {
    if (method.name == name) return method;
    names += (names.empty() ? "" : ", ") + method.name;
  }
  throw Error(ErrorCode::UnknownSetting, {"settings", "method", "one of " + names, name});
}

std::vector<std::string> methodNames() {
  std::vector<std::string> names;
  for (const Method& method : methods()) names.push_back(method.name);
  return names;
}

std::string methodSummary(const std::string& method) { return findMethod(method).summary; }

const std::vector<SettingDescription>& methodSettings(const std::string& method) {
  return findMethod(method).settings;
}

}  // namespace quell
