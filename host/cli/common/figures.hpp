// Figures as JSON and as text.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "host/metrics/report.hpp"

namespace quell::cli {

inline double mebibytes(std::uint64_t bytes) { return static_cast<double>(bytes) / (1024.0 * 1024.0); }

/// JSON has no NaN and no infinity: null for these, and for what is absent.
template <class Json>
Json number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

/// Adds every metric to `object`, in their order.
template <class Json>
void addFigures(Json& object, const metrics::ErrorFigures& figures) {
  for (std::size_t i = 0; i < figures.values.size(); ++i)
    object[metrics::imageMetrics()[i].key] = number<Json>(figures.values[i]);
}

/// With so many digits behind the point; `absent` where there is no value.
std::string fixed(const std::optional<double>& value, int digits, const char* absent);

/// Six significant digits; empty where there is no finite value.
std::string csvNumber(const std::optional<double>& value);

}  // namespace quell::cli
