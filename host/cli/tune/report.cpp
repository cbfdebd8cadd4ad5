#include "host/cli/tune/report.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>

#include "host/cli/common/figures.hpp"
#include "host/cli/common/text_table.hpp"

namespace quell::cli {
namespace {

using nlohmann::json;

// Under these names errors stand in the table.
const char* labelOf(std::size_t tunedMetric) { return plainOf(*tunedMetrics()[tunedMetric]).label; }

std::string legend() {
  std::vector<std::string> minimised, shown;
  for (const std::size_t metric : minimisedMetrics()) minimised.push_back(labelOf(metric));
  for (std::size_t metric = 0; metric < tunedMetrics().size(); ++metric) shown.push_back(labelOf(metric));
  return fmt::format(
      "Time, {}: geometric means over the sequences, relative to the defaults; * marks the Pareto set of "
      "these.\nPer sequence: {} / temporal error / median milliseconds a frame. Errors before TAA, on "
      "display-encoded "
      "values; RMSE is the unbiased one.\n",
      fmt::join(minimised, " and "), fmt::join(shown, " / "));
}

// The last part of a directory's path.
std::string shortName(const std::string& name) {
  const std::string last = (std::filesystem::path(name) / "").parent_path().filename().string();
  return last.empty() ? name : last;
}

std::string settingName(const TunedSetting& setting, const TuningArguments& arguments) {
  const std::string text = setting.figures.plan.settingsText();
  return text.empty() ? fmt::format("defaults ({})", arguments.defaults) : text;
}

// The errors, flicker and milliseconds.
std::string figuresText(const SequenceFigures& figures) {
  std::string text;
  for (std::size_t i = 0; i < figures.errors.size(); ++i)
    text += fixed(figures.errors[i], tunedMetrics()[i]->digits, "") + " / ";
  text += fixed(figures.temporalError, metrics::kTemporalError.digits, "-") + " / ";
  return text + fixed(figures.frameMs, 2, "");
}

TextTable makeTable(const TuningTable& table, const TuningResult& result) {
  TextTable text;
  text.header = {"settings", "", "time"};
  for (const std::size_t metric : minimisedMetrics()) text.header.push_back(labelOf(metric));
  for (const char* heading : {"ms", "copies"}) text.header.push_back(heading);
  for (const EvaluatedSequence& sequence : table.evaluation.sequences)
    text.header.push_back(shortName(sequence.name));
  for (const TunedSetting& setting : table.settings) {
    std::vector<std::string> row = {settingName(setting, result.arguments), setting.pareto ? "*" : "",
                                    fixed(setting.relative.time, 3, "")};
    for (const double error : setting.relative.errors) row.push_back(fixed(error, 4, ""));
    row.push_back(fixed(setting.frameMs, 2, ""));
    row.push_back(fixed(setting.frameMs / result.copy.copyMs, 1, ""));
    for (const SequenceFigures& figures : setting.figures.sequences) row.push_back(figuresText(figures));
    text.rows.push_back(row);
  }
  return text;
}

std::string sequencesText(const std::vector<EvaluatedSequence>& sequences) {
  std::string text;
  for (const EvaluatedSequence& one : sequences)
    text += fmt::format("- {}: {}x{}, {} frames, references ({}) of {}{}\n", one.name, one.size.width,
                        one.size.height, one.frames, toString(one.referenceKind),
                        fmt::join(one.references, ", "), one.unbiased ? "" : "; of one half: plain RMSE");
  return text;
}

std::string refusedText(const TuningTable& table) {
  std::string text;
  for (const RefusedSetting& one : table.evaluation.refused)
    text += fmt::format("- refused on {}: {}: {}\n", one.sequence, one.plan.settingsText(), one.reason);
  return text.empty() ? "" : "\n" + text;
}

// `format` makes text of a TextTable.
template <class Format>
std::string partText(const char* title, const TuningTable& table, const TuningResult& result,
                     const Format& format) {
  return fmt::format("\n{}:\n\n{}{}\n{}", title, sequencesText(table.evaluation.sequences),
                     refusedText(table), format(makeTable(table, result)));
}

template <class Format>
std::string resultText(const TuningResult& result, const Format& format) {
  std::string text = fmt::format(
      "Settings of {} on {} (driver {}), {} timed rounds; one copy takes {:.3f} ms. Times that differ by up "
      "to {:g} % "
      "count as equal.\n{}",
      result.arguments.method, result.tuned.evaluation.device.name,
      result.tuned.evaluation.device.driverVersion, result.arguments.evaluation.rounds, result.copy.copyMs,
      100.0 * result.arguments.timeTolerance, legend());
  text += partText("Tuned on", result.tuned, result, format);
  if (result.confirmed)
    text += partText("Confirmed on (the defaults and the Pareto set from above)", *result.confirmed, result,
                     format);
  else
    text += "\nNot confirmed on other sequences.\n";
  return text;
}

json sequenceJson(const EvaluatedSequence& sequence) {
  return {{"name", sequence.name},
          {"width", sequence.size.width},
          {"height", sequence.size.height},
          {"frames", sequence.frames},
          {"references", sequence.references},
          {"reference", toString(sequence.referenceKind)},
          {"unbiased", sequence.unbiased}};
}

json settingJson(const TunedSetting& setting, const std::vector<EvaluatedSequence>& sequences,
                 double copyMs) {
  json result = {{"settings", json::object()},
                 {"pareto", setting.pareto},
                 {"relative_time", setting.relative.time},
                 {"frame_ms", setting.frameMs},
                 {"copies", setting.frameMs / copyMs},
                 {"sequences", json::array()}};
  for (std::size_t i = 0; i < setting.relative.errors.size(); ++i) {
    const metrics::Metric& metric = plainOf(*tunedMetrics()[minimisedMetrics()[i]]);
    result[std::string("relative_") + metric.key] = setting.relative.errors[i];
  }
  for (const auto& [name, value] : setting.figures.plan.assignments) result["settings"][name] = value;
  for (std::size_t i = 0; i < sequences.size(); ++i) {
    const SequenceFigures& figures = setting.figures.sequences[i];
    json sequence = {
        {"name", sequences[i].name}, {"frame_ms", figures.frameMs}, {"relative_time", figures.relativeTime}};
    for (std::size_t m = 0; m < figures.errors.size(); ++m)
      sequence[tunedMetrics()[m]->key] = number<json>(figures.errors[m]);
    sequence[metrics::kTemporalError.key] = number<json>(figures.temporalError);
    result["sequences"].push_back(sequence);
  }
  return result;
}

json tableJson(const TuningTable& table, double copyMs) {
  json result = {{"sequences", json::array()}, {"settings", json::array()}, {"refused", json::array()}};
  for (const EvaluatedSequence& sequence : table.evaluation.sequences)
    result["sequences"].push_back(sequenceJson(sequence));
  for (const TunedSetting& setting : table.settings)
    result["settings"].push_back(settingJson(setting, table.evaluation.sequences, copyMs));
  for (const RefusedSetting& one : table.evaluation.refused)
    result["refused"].push_back(
        {{"settings", one.plan.settingsText()}, {"sequence", one.sequence}, {"reason", one.reason}});
  return result;
}

}  // namespace

std::string toText(const TuningResult& result) {
  return resultText(result, [](const TextTable& table) { return toText(table); });
}

std::string toMarkdown(const TuningResult& result) {
  return resultText(result, [](const TextTable& table) { return toMarkdown(table); });
}

json toJson(const TuningResult& result) {
  const double copyMs = result.copy.copyMs;
  return {{"method", result.arguments.method},
          {"defaults", result.arguments.defaults},
          {"device", result.tuned.evaluation.device.name},
          {"driver", result.tuned.evaluation.device.driverVersion},
          {"repeat", result.arguments.evaluation.rounds},
          {"time_tolerance", result.arguments.timeTolerance},
          {"copy_ms", copyMs},
          {"copy_gbs", result.copy.gigabytesPerSecond},
          {"tuned", tableJson(result.tuned, copyMs)},
          {"confirmed", result.confirmed ? tableJson(*result.confirmed, copyMs) : json(nullptr)}};
}

}  // namespace quell::cli
