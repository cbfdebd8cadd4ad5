#include "host/cli/common/figures.hpp"

#include <fmt/format.h>

namespace quell::cli {

std::string fixed(const std::optional<double>& value, int digits, const char* absent) {
  return value ? fmt::format("{:.{}f}", *value, digits) : absent;
}

std::string csvNumber(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:.6g}", *value) : "";
}

}  // namespace quell::cli
