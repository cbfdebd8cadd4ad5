#include "host/core/number_text.hpp"

#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace quell {
namespace {

/// Whole numbers from here on are written as powers of ten: 1e+07.
constexpr double kLeastPower = 1e7;

}  // namespace

bool parseNumber(const std::string& text, double& value) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  stream >> value;
  return !stream.fail() && stream.peek() == std::istringstream::traits_type::eof();
}

std::string numberText(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  if (value == std::trunc(value) && std::abs(value) < kLeastPower) {
    stream << std::fixed << std::setprecision(0) << value;
    return stream.str();
  }
  for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    stream.str("");
    stream.precision(digits);
    stream << value;
    double readBack = 0.0;
    if (parseNumber(stream.str(), readBack) && readBack == value) break;
  }
  return stream.str();
}

}  // namespace quell
