#include "host/cli/bench/roofline.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <quell/error.hpp>

#include "host/cli/common/command_arguments.hpp"
#include "host/io/atomic_file.hpp"

namespace quell::cli {
namespace {

// Milliseconds of so many things at 1e9 of them a second.
double timeMs(double count, double gigaPerSecond) {
  return gigaPerSecond > 0.0 ? count * 1e-6 / gigaPerSecond : 0.0;
}

}  // namespace

OperationCounts::OperationCounts(const std::string& file) {
  const std::string text = io::readFile(file);
  try {
    nlohmann::json::parse(text).get_to(m_counts);
  } catch (const nlohmann::json::exception& error) {
    refuse("bench", "--operations", "a file written by bench/count_operations", file + ": " + error.what());
  }
}

double OperationCounts::perPixel(const PlannedRun& run, const std::string& label) const {
  const auto countOf = [&](const std::map<std::string, double>& stages) {
    const auto stage = stages.find(label);
    return stage == stages.end() ? 0.0 : stage->second;
  };
  for (const std::string& name : {run.name(), run.method}) {
    const auto counted = m_counts.find(name);
    if (counted != m_counts.end() && countOf(counted->second) > 0.0) return countOf(counted->second);
  }
  for (const auto& [name, stages] : m_counts)
    if (name.rfind(run.method + " ", 0) == 0 && countOf(stages) > 0.0) return countOf(stages);
  return 0.0;
}

double rooflineMs(double bytes, double operations, double gigabytesPerSecond, double gigaflops) {
  return std::max(timeMs(bytes, gigabytesPerSecond), timeMs(operations, gigaflops));
}

}  // namespace quell::cli
