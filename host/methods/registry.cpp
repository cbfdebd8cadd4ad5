#include <quell/error.hpp>

#include "host/methods/atrous.hpp"
#include "host/methods/bmfr.hpp"
#include "host/methods/method.hpp"
#include "host/methods/quell.hpp"
#include "host/methods/svgf.hpp"

namespace quell {

const std::vector<Method>& methods() {
  static const std::vector<Method> all = {quellMethod(), bmfrMethod(), svgfMethod(), atrousMethod()};
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
