// What the denoise command says about time and error, as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/metrics/report.hpp"

namespace quell::cli {

/// Figures of one frame that has a reference.
struct FrameErrors {
  int frame = 0;
  metrics::ErrorFigures noisy;    ///< the input itself
  metrics::ErrorFigures linear;   ///< before TAA
  metrics::ErrorFigures display;  ///< after TAA, where that is on
};

struct DenoiseReport {
  DeviceInfo device;
  Settings settings;
  Size size;
  std::size_t frames = 0;
  MemoryUse memory;
  std::string outputHash;
  std::optional<Timings> timings;
  std::optional<double> copyMs;   ///< the unit *copy*, see bench/copy_bandwidth.hpp
  std::optional<double> copyGbs;  ///< GB/s
  std::vector<FrameErrors> errors;
};

nlohmann::json toJson(const DenoiseReport& report);
void print(const DenoiseReport& report);

}  // namespace quell::cli
