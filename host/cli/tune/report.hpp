// What the tune command says.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/cli/tune/result.hpp"

namespace quell::cli {

std::string toText(const TuningResult& result);
std::string toMarkdown(const TuningResult& result);

/// {method, defaults, device, driver, repeat, time_tolerance, copy_ms, copy_gbs, tuned, confirmed}; the last two, of
/// which confirmed may be null: {sequences, settings, refused}.
nlohmann::json toJson(const TuningResult& result);

}  // namespace quell::cli
