#include "host/cli/bench/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/cli/common/command_arguments.hpp"
#include "host/io/atomic_file.hpp"
#include "host/metrics/metric_table.hpp"

namespace quell::cli {
namespace {

using nlohmann::json;

constexpr double kLeastTimeChange = 0.02;  // of the time: what rounds of a quiet machine differ by
constexpr double kLeastErrorChange =
    0.005;  // of the figure: outputs are deterministic, so any change is real

constexpr char kExpected[] = "a file written by quell bench --json";

struct Counts {
  int compared = 0, slower = 0, faster = 0, worse = 0, better = 0;
};

std::string keyOf(const json& run) {
  const std::string sweep = run.value("sweep", "");
  // Numbers as they are written: what a damaged file says may be no integer that there is.
  return fmt::format("{} on {}, {}x{}, {} frames{}", run.at("run").get<std::string>(),
                     run.at("input").get<std::string>(), run.at("width").dump(), run.at("height").dump(),
                     run.at("frames").dump(), sweep.empty() ? "" : ", sweep " + sweep);
}

const json* findRun(const json& result, const std::string& key) {
  for (const json& run : result.at("runs"))
    if (keyOf(run) == key) return &run;
  return nullptr;
}

// Least and largest median of a round, in copies, so that machines and their load matter less.
std::pair<double, double> rangeInCopies(const json& run) {
  const auto rounds = run.at("round_medians_ms").get<std::vector<double>>();
  if (rounds.empty()) return {0.0, 0.0};
  const auto [least, most] = std::minmax_element(rounds.begin(), rounds.end());
  const double copyMs = run.at("copy_ms");
  return {*least / copyMs, *most / copyMs};
}

void compareTimes(const std::string& key, const json& before, const json& now, Counts& counts,
                  std::string& text) {
  const auto [oldLeast, oldMost] = rangeInCopies(before);
  const auto [newLeast, newMost] = rangeInCopies(now);
  const bool slower = newLeast > oldMost * (1.0 + kLeastTimeChange);
  const bool faster = newMost < oldLeast * (1.0 - kLeastTimeChange);
  if (!slower && !faster) return;
  ++(slower ? counts.slower : counts.faster);
  text += fmt::format("{}: {}: {:.1f} to {:.1f} copies a frame, was {:.1f} to {:.1f}\n",
                      slower ? "slower" : "faster", key, newLeast, newMost, oldLeast, oldMost);
}

void compareFigure(const std::string& what, const metrics::Metric& metric, const json& before,
                   const json& now, Counts& counts, std::string& text) {
  if (!before.is_number() || !now.is_number()) return;
  const double old = before, current = now;
  if (std::abs(current - old) <= kLeastErrorChange * std::abs(old)) return;
  const bool better = (current > old) == metric.higherIsBetter();
  ++(better ? counts.better : counts.worse);
  text += fmt::format("{}: {} {:.5g}, was {:.5g}\n", better ? "better" : "worse", what, current, old);
}

// Null where there is none.
json valueOf(const json& object, const char* key) { return object.value(key, json()); }

void compareErrors(const std::string& key, const json& before, const json& now, Counts& counts,
                   std::string& text) {
  const auto errorsOf = [](const json& run) { return run.value("errors", json::array()); };
  for (const json& frame : errorsOf(now)) {
    for (const json& old : errorsOf(before)) {
      if (old.at("frame") != frame.at("frame")) continue;
      if (valueOf(old, "linear_reference") != valueOf(frame, "linear_reference")) continue;
      for (const metrics::Metric& metric : metrics::imageMetrics()) {
        if (!metric.compared) continue;
        compareFigure(fmt::format("{}, frame {}: {}", key, frame.at("frame").dump(), metric.key), metric,
                      valueOf(old.at("linear"), metric.key), valueOf(frame.at("linear"), metric.key), counts,
                      text);
      }
    }
  }
  const metrics::Metric& temporal = metrics::kTemporalError;
  compareFigure(fmt::format("{}: {}", key, temporal.label), temporal, valueOf(before, temporal.key),
                valueOf(now, temporal.key), counts, text);
}

std::string compareRuns(const json& before, const json& now) {
  Counts counts;
  std::string text;
  for (const json& run : now.at("runs")) {
    const std::string key = keyOf(run);
    const json* old = findRun(before, key);
    if (old == nullptr) continue;
    ++counts.compared;
    compareTimes(key, *old, run, counts, text);
    compareErrors(key, *old, run, counts, text);
  }
  return text + fmt::format("{} runs compared: {} slower, {} faster; {} figures worse, {} better\n",
                            counts.compared, counts.slower, counts.faster, counts.worse, counts.better);
}

}  // namespace

json readBench(const std::string& file) {
  json result = json::parse(io::readFile(file), nullptr, false);
  if (!result.is_object() || !result.contains("runs")) refuse("bench", "--compare", kExpected, file);
  return result;
}

std::string compareBench(const json& before, const json& now, const std::string& file) {
  try {
    return compareRuns(before, now);
  } catch (const json::exception& error) {
    refuse("bench", "--compare", kExpected, file + ": " + error.what());
  }
}

}  // namespace quell::cli
