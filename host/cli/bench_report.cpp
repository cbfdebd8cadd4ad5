#include "host/cli/bench_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace quell::cli {
namespace {

using nlohmann::json;

constexpr double kMebibyte = 1024.0 * 1024.0;
constexpr double kMegapixel = 1e6;

constexpr char kCsvHeader[] =
    "input,method,settings,width,height,frames,repeat,memory_bytes,kind,name,time_source,median_ms,min_ms,"
    "max_ms,bytes,gbs,copies,copy_share,rmse,unbiased_rmse,psnr,ssim,flip,relmse\n";
constexpr char kNoTimes[] = ",,,,,,,,";
constexpr char kNoErrors[] = ",,,,,,";

json runJson(const BenchRun& run, const CopyBandwidth& copy) {
  json result = toJson(run.report);
  result["input"] = run.input;
  const std::vector<StageTimings>& stages = run.report.timings->stages;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const double gbs = gigabytesPerSecond(stages[i].bytesMoved, stages[i].time);
    result["stages"][i]["gbs"] = gbs;
    result["stages"][i]["copies"] = stages[i].time.medianMs / copy.copyMs;
    result["stages"][i]["copy_share"] = gbs / copy.gigabytesPerSecond;
  }
  return result;
}

std::string csvCell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csvNumber(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:.6g}", *value) : "";
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

// The cells from `rmse` to `relmse`, each after its comma.
std::string csvErrors(const metrics::ErrorFigures& figures) {
  return fmt::format(",{},{},{},{},{},{}", csvNumber(figures.rmse), csvNumber(figures.unbiasedRmse),
                     csvNumber(figures.psnr), csvNumber(figures.ssim), csvNumber(figures.flip),
                     csvNumber(figures.relMse));
}

std::string csvLines(const BenchRun& run, const BenchResult& result) {
  const std::string start = csvRun(run, result.rounds);
  const Timings& timings = *run.report.timings;
  std::string lines;
  const auto addTimes = [&](const char* kind, const std::string& name, const TimeStatistics& time,
                            std::uint64_t bytes) {
    lines += fmt::format("{},{},{}{}{}\n", start, kind, name,
                         csvTimes(time, bytes, timings.source, result.copy), kNoErrors);
  };
  const auto addErrors = [&](const char* image, int frame, const metrics::ErrorFigures& figures) {
    lines += fmt::format("{},error,frame {} {}{}{}\n", start, frame, image, kNoTimes, csvErrors(figures));
  };
  for (const StageTimings& stage : timings.stages)
    addTimes("stage", stage.stage, stage.time, stage.bytesMoved);
  const StageTimings sum = sumOfStages(timings);
  addTimes("sum", sum.stage, sum.time, sum.bytesMoved);
  addTimes("frame", "frame", timings.frame, sum.bytesMoved);
  for (const FrameErrors& errors : run.report.errors) {
    addErrors("noisy", errors.frame, errors.noisy);
    addErrors("linear", errors.frame, errors.linear);
    addErrors("display", errors.frame, errors.display);
  }
  return lines;
}

std::string errorsText(const std::vector<FrameErrors>& errors) {
  std::string text;
  for (const FrameErrors& frame : errors) {
    const std::optional<double>& error = frame.linear.unbiasedRmse;
    text += fmt::format("  {}: {}", frame.frame, error ? fmt::format("{:.4f}", *error) : "-");
  }
  return text;
}

void printSummaryRow(const BenchRun& run, std::size_t nameWidth) {
  const DenoiseReport& report = run.report;
  const double sumMs = sumOfStages(*report.timings).time.medianMs;
  const double megapixels = double(report.size.width) * double(report.size.height) / kMegapixel;
  fmt::print("  {:<{}}{:>10.2f}{:>9.1f}{:>10.2f}{:>9.2f}{:>9.1f}{:>8}{}\n", run.plan.name(), nameWidth, sumMs,
             sumMs / *report.copyMs, report.timings->frame.medianMs, sumMs / megapixels,
             double(report.memory.totalBytes) / kMebibyte, toString(report.timings->source),
             errorsText(report.errors));
}

// Runs of one sequence stand together under its name.
void printSummary(const BenchResult& result) {
  std::size_t nameWidth = 0;
  for (const BenchRun& run : result.runs) nameWidth = std::max(nameWidth, run.plan.name().size());
  fmt::print("\n  {:<{}}{:>10}{:>9}{:>10}{:>9}{:>9}{:>8}  unbiased RMSE per frame\n", "median times",
             nameWidth, "stages ms", "copies", "frame ms", "ms/Mpx", "MiB", "clock");
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

}  // namespace

json toJson(const BenchResult& result) {
  json measured = json::array(), runs = json::array(), skipped = json::array();
  for (const CopyBandwidth& copy : result.copyMeasurements) measured.push_back(copy.gigabytesPerSecond);
  for (const BenchRun& run : result.runs) runs.push_back(runJson(run, result.copy));
  for (const SkippedRun& run : result.skipped)
    skipped.push_back({{"input", run.input},
                       {"width", run.size.width},
                       {"height", run.size.height},
                       {"run", run.plan.name()},
                       {"reason", run.reason}});
  return {{"copy_ms", result.copy.copyMs},
          {"copy_gbs", result.copy.gigabytesPerSecond},
          {"copy_gbs_measured", measured},
          {"repeat", result.rounds},
          {"runs", runs},
          {"skipped", skipped}};
}

std::string toCsv(const BenchResult& result) {
  std::string text = kCsvHeader;
  for (const BenchRun& run : result.runs) text += csvLines(run, result);
  return text;
}

void print(const BenchResult& result) {
  for (const BenchRun& run : result.runs) {
    fmt::print("\n{} on {}\n", run.plan.name(), run.input);
    print(run.report);
  }
  printCopies(result);
  printSummary(result);
}

}  // namespace quell::cli
