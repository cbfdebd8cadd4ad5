#include "host/cli/bench/report.hpp"

#include <fmt/format.h>
#include <quell/quell.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "host/cli/common/figures.hpp"
#include "host/core/median.hpp"

namespace quell::cli {
namespace {

using nlohmann::json;

constexpr double kMegapixel = 1e6;

// For a CSV cell of every metric, each after its comma.
template <class Cell>
std::string csvMetrics(const Cell& cell) {
  std::string cells;
  for (std::size_t i = 0; i < metrics::imageMetrics().size(); ++i) cells += "," + cell(i);
  return cells;
}

std::string csvHeader() {
  return "input,method,settings,width,height,frames,repeat,memory_bytes,kind,name,time_source,median_ms,min_"
         "ms,"
         "max_ms,bytes,gbs,copies,copy_share" +
         csvMetrics([](std::size_t i) { return std::string(metrics::imageMetrics()[i].key); }) +
         ",reference,label,skipped_share,operations,bound_ms,sweep," + metrics::kTemporalError.key +
         ",build_cold_ms,build_cached_ms\n";
}

constexpr char kNoTimes[] = ",,,,,,,,";
constexpr char kNoReference[] = ",";
constexpr char kNoStage[] = ",,,,";

double operationsOf(const BenchRun& run, const StageTimings& stage, const BenchResult& result) {
  return result.operations.perPixel(run.plan, stage.label) * double(run.report.size.width) *
         double(run.report.size.height) * workShare(stage);
}

double boundMs(const BenchRun& run, const StageTimings& stage, const BenchResult& result) {
  return rooflineMs(double(stage.bytesMoved), operationsOf(run, stage, result),
                    result.copy.gigabytesPerSecond, result.fmaGigaflops);
}

// Medians over the frames of each round.
json roundMedians(const BenchRun& run) {
  json medians = json::array();
  for (const std::vector<double>& round : run.frameMs)
    if (!round.empty()) medians.push_back(median(round));
  return medians;
}

// Medians over the rounds of each frame.
json frameMedians(const BenchRun& run) {
  json medians = json::array();
  const std::size_t frames = run.frameMs.empty() ? 0 : run.frameMs.front().size();
  for (std::size_t frame = 0; frame < frames; ++frame) {
    std::vector<double> rounds;
    for (const std::vector<double>& round : run.frameMs) rounds.push_back(round[frame]);
    medians.push_back(median(rounds));
  }
  return medians;
}

// Of this executable: what its host code was compiled with.
json buildJson() {
#if defined(__clang__)
  const std::string compiler = "Clang " __clang_version__;
#elif defined(__GNUC__)
  const std::string compiler = "GCC " __VERSION__;
#else
  const std::string compiler = "unknown";
#endif
#ifdef NDEBUG
  constexpr bool kAssertions = false;
#else
  constexpr bool kAssertions = true;
#endif
  return {{"version", quellVersion()}, {"compiler", compiler}, {"assertions", kAssertions}};
}

json assignmentsJson(const PlannedRun& plan) {
  json assignments = json::object();
  for (const auto& [setting, value] : plan.assignments) assignments[setting] = value;
  return assignments;
}

void addStageFigures(json& stageJson, const BenchRun& run, const StageTimings& stage,
                     const BenchResult& result) {
  const double gbs = gigabytesPerSecond(stage.bytesMoved, stage.time);
  stageJson["gbs"] = gbs;
  stageJson["copies"] = stage.time.medianMs / result.copy.copyMs;
  stageJson["copy_share"] = gbs / result.copy.gigabytesPerSecond;
  stageJson["bound_ms"] = boundMs(run, stage, result);
  if (const double operations = operationsOf(run, stage, result); operations > 0.0)
    stageJson["operations"] = operations;
}

json runJson(const BenchRun& run, const BenchResult& result) {
  json object = toJson(run.report);
  object["input"] = run.input;
  object["run"] = run.plan.name();
  object["assignments"] = assignmentsJson(run.plan);
  if (!run.plan.sweep.empty()) object["sweep"] = run.plan.sweep;
  if (run.build) object["build_ms"] = {{"cold", run.build->coldMs}, {"cached", run.build->cachedMs}};
  object["round_medians_ms"] = roundMedians(run);
  object["frame_medians_ms"] = frameMedians(run);
  const std::vector<StageTimings>& stages = run.report.timings->stages;
  for (std::size_t i = 0; i < stages.size(); ++i)
    addStageFigures(object["stages"][i], run, stages[i], result);
  return object;
}

std::string csvCell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

// The cells from `input` to `memory_bytes`.
std::string csvRun(const BenchRun& run, int rounds) {
  const DenoiseReport& report = run.report;
  return fmt::format("{},{},{},{},{},{},{},{}", csvCell(run.input), run.plan.method,
                     csvCell(run.plan.settingsText()), report.size.width, report.size.height, report.frames,
                     rounds, report.memory.totalBytes);
}

// The cells from `time_source` to `copy_share`, each after its comma.
std::string csvTimes(const TimeStatistics& time, std::uint64_t bytes, TimeSource source,
                     const CopyBandwidth& copy) {
  const double gbs = gigabytesPerSecond(bytes, time);
  return fmt::format(",{},{:.6g},{:.6g},{:.6g},{},{:.6g},{:.6g},{:.6g}", toString(source), time.medianMs,
                     time.minMs, time.maxMs, bytes, gbs, time.medianMs / copy.copyMs,
                     gbs / copy.gigabytesPerSecond);
}

std::string csvErrors(const metrics::ErrorFigures& figures) {
  return csvMetrics([&](std::size_t i) { return csvNumber(figures.values[i]); });
}

// The cells from `label` to `bound_ms`, each after its comma.
std::string csvStage(const BenchRun& run, const StageTimings& stage, const BenchResult& result) {
  const double operations = operationsOf(run, stage, result);
  return fmt::format(",{},{},{},{:.6g}", csvCell(stage.label), csvNumber(stage.skippedShare),
                     operations > 0.0 ? csvNumber(operations) : "", boundMs(run, stage, result));
}

// The cells from `sweep` to `build_cached_ms`, each after its comma.
std::string csvEnd(const BenchRun& run) {
  const auto build = [&](double BuildTimes::*time) {
    return run.build ? fmt::format("{:.6g}", *run.build.*time) : std::string();
  };
  return fmt::format(",{},{},{},{}", run.plan.sweep, csvNumber(run.report.temporalError),
                     build(&BuildTimes::coldMs), build(&BuildTimes::cachedMs));
}

std::string csvLines(const BenchRun& run, const BenchResult& result) {
  const std::string start = csvRun(run, result.rounds), end = csvEnd(run);
  const std::string noErrors = csvMetrics([](std::size_t) { return std::string(); });
  const Timings& timings = *run.report.timings;
  std::string lines;
  const auto addTimes = [&](const char* kind, const std::string& name, const TimeStatistics& time,
                            std::uint64_t bytes, const std::string& stage) {
    lines +=
        fmt::format("{},{},{}{}{}{}{}{}\n", start, kind, name,
                    csvTimes(time, bytes, timings.source, result.copy), noErrors, kNoReference, stage, end);
  };
  const auto addErrors = [&](const char* image, int frame, const metrics::ErrorFigures& figures,
                             io::ReferenceKind reference) {
    lines += fmt::format("{},error,frame {} {}{}{},{}{}{}\n", start, frame, image, kNoTimes,
                         csvErrors(figures), toString(reference), kNoStage, end);
  };
  for (const StageTimings& stage : timings.stages)
    addTimes("stage", stage.stage, stage.time, stage.bytesMoved, csvStage(run, stage, result));
  const StageTimings sum = sumOfStages(timings);
  addTimes("sum", sum.stage, sum.time, sum.bytesMoved, kNoStage);
  addTimes("frame", "frame", timings.frame, sum.bytesMoved, kNoStage);
  for (const FrameErrors& errors : run.report.errors) {
    addErrors("noisy", errors.frame, errors.noisy, errors.reference);
    addErrors("linear", errors.frame, errors.linear, errors.reference);
    addErrors("display", errors.frame, errors.display, errors.reference);
  }
  return lines;
}

std::string errorsText(const std::vector<FrameErrors>& errors) {
  const metrics::Metric& headline = metrics::headlineMetric();
  std::string text;
  for (const FrameErrors& frame : errors)
    text +=
        fmt::format("  {}: {} ({})", frame.frame, fixed(frame.linear.at(headline.key), headline.digits, "-"),
                    toString(frame.reference));
  return text;
}

void printSummaryRow(const BenchRun& run, std::size_t nameWidth) {
  const DenoiseReport& report = run.report;
  const double sumMs = sumOfStages(*report.timings).time.medianMs;
  const double megapixels = double(report.size.width) * double(report.size.height) / kMegapixel;
  fmt::print("  {:<{}}{:>10.2f}{:>9.1f}{:>10.2f}{:>9.2f}{:>9.1f}{:>8}{}\n", run.plan.name(), nameWidth, sumMs,
             sumMs / *report.copyMs, report.timings->frame.medianMs, sumMs / megapixels,
             mebibytes(report.memory.totalBytes), toString(report.timings->source),
             errorsText(report.errors));
}

// Runs of one sequence stand together under its name.
void printSummary(const BenchResult& result) {
  std::size_t nameWidth = 0;
  for (const BenchRun& run : result.runs) nameWidth = std::max(nameWidth, run.plan.name().size());
  fmt::print("\n  {:<{}}{:>10}{:>9}{:>10}{:>9}{:>9}{:>8}  {} per frame (reference)\n", "median times",
             nameWidth, "stages ms", "copies", "frame ms", "ms/Mpx", "MiB", "clock",
             metrics::headlineMetric().label);
  const BenchRun* previous = nullptr;
  for (const BenchRun& run : result.runs) {
    const Size size = run.report.size;
    if (previous == nullptr || previous->input != run.input || previous->report.size != size)
      fmt::print("{}, {}x{}, {} frames x {}\n", run.input, size.width, size.height, run.report.frames,
                 result.rounds);
    printSummaryRow(run, nameWidth);
    previous = &run;
  }
}

void printCopies(const BenchResult& result) {
  const auto [least, most] =
      std::minmax_element(result.copyMeasurements.begin(), result.copyMeasurements.end(),
                          [](const CopyBandwidth& a, const CopyBandwidth& b) { return a.copyMs < b.copyMs; });
  fmt::print("\none copy: {:.3f} ms, {:.1f} GB/s (mean of {} measurements, {:.3f} to {:.3f} ms)\n",
             result.copy.copyMs, result.copy.gigabytesPerSecond, result.copyMeasurements.size(),
             least->copyMs, most->copyMs);
}

void printRoofline(const BenchRun& run, const BenchResult& result) {
  fmt::print("  {:<32}{:>9}{:>9}{:>9}{:>9}\n", "roofline", "ms", "bound ms", "of bound", "flop/B");
  for (const StageTimings& stage : run.report.timings->stages) {
    const double bound = boundMs(run, stage, result);
    const double operations = operationsOf(run, stage, result);
    fmt::print("  {:<32}{:>9.2f}{:>9.2f}{:>7.0f} %{:>9}\n", stage.label, stage.time.medianMs, bound,
               stage.time.medianMs > 0.0 ? 100.0 * bound / stage.time.medianMs : 0.0,
               operations > 0.0 && stage.bytesMoved > 0
                   ? fmt::format("{:.1f}", operations / double(stage.bytesMoved))
                   : "-");
  }
}

void printBuild(const BuildTimes& build) {
  fmt::print("  ready after {:.0f} ms with all kernels unknown, {:.0f} ms with kernels from the cache\n",
             build.coldMs, build.cachedMs);
}

}  // namespace

json toJson(const BenchResult& result) {
  json measured = json::array(), runs = json::array(), skipped = json::array();
  for (const CopyBandwidth& copy : result.copyMeasurements) measured.push_back(copy.gigabytesPerSecond);
  for (const BenchRun& run : result.runs) runs.push_back(runJson(run, result));
  for (const SkippedRun& run : result.skipped)
    skipped.push_back({{"input", run.input},
                       {"width", run.size.width},
                       {"height", run.size.height},
                       {"run", run.plan.name()},
                       {"reason", run.reason}});
  json all = {{"copy_ms", result.copy.copyMs},
              {"copy_gbs", result.copy.gigabytesPerSecond},
              {"copy_gbs_measured", measured},
              {"build", buildJson()},
              {"repeat", result.rounds},
              {"runs", runs},
              {"skipped", skipped}};
  if (result.fmaGigaflops > 0.0) all["fma_gflops"] = result.fmaGigaflops;
  return all;
}

std::string toCsv(const BenchResult& result) {
  std::string text = csvHeader();
  for (const BenchRun& run : result.runs) text += csvLines(run, result);
  return text;
}

void print(const BenchResult& result) {
  for (const BenchRun& run : result.runs) {
    fmt::print("\n{} on {}\n", run.plan.name(), run.input);
    print(run.report);
    if (run.build) printBuild(*run.build);
    if (result.fmaGigaflops > 0.0) printRoofline(run, result);
  }
  printCopies(result);
  if (result.fmaGigaflops > 0.0) fmt::print("multiply-adds: {:.1f} GFLOP/s\n", result.fmaGigaflops);
  printSummary(result);
}

}  // namespace quell::cli
