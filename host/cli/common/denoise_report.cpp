#include "host/cli/common/denoise_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "host/cli/common/figures.hpp"
#include "host/metrics/display_encoding.hpp"

namespace quell::cli {
namespace {

using nlohmann::json;

json settingsJson(const Settings& settings) {
  json result = json::object();
  for (const SettingDescription& setting : settings.descriptions()) {
    const bool text = setting.kind != SettingKind::Real && setting.kind != SettingKind::Integer;
    if (text) {
      result[setting.name] = settings.text(setting.name);
    } else {
      result[setting.name] = settings.get(setting.name);
    }
  }
  return result;
}

json statisticsJson(const TimeStatistics& time) {
  return {{"median", time.medianMs}, {"min", time.minMs}, {"max", time.maxMs}};
}

json figuresJson(const metrics::ErrorFigures& figures) {
  json result = json::object();
  addFigures(result, figures);
  return result;
}

}  // namespace

json toJson(const Timings& timings) {
  json result = {{"time_source", toString(timings.source)},
                 {"frame_ms", statisticsJson(timings.frame)},
                 {"stages", json::array()}};
  for (const StageTimings& stage : timings.stages) {
    result["stages"].push_back({{"name", stage.stage},
                                {"label", stage.label},
                                {"median_ms", stage.time.medianMs},
                                {"min_ms", stage.time.minMs},
                                {"max_ms", stage.time.maxMs},
                                {"bytes", stage.bytesMoved}});
    if (stage.skippedShare) result["stages"].back()["skipped_share"] = *stage.skippedShare;
  }
  return result;
}

namespace {

std::string rowText(const std::string& name, const TimeStatistics& time, std::uint64_t bytes,
                    const DenoiseReport& report) {
  const double gbs = gigabytesPerSecond(bytes, time);
  std::string row = fmt::format("  {:<32}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.1f}{:>8.1f}", name, time.medianMs,
                                time.minMs, time.maxMs, static_cast<double>(bytes) * 1e-6, gbs);
  if (report.copyMs)
    row += fmt::format("{:>8.1f}{:>7.0f} %", time.medianMs / *report.copyMs, 100.0 * gbs / *report.copyGbs);
  return row + "\n";
}

std::string skippedText(const StageTimings& stage) {
  return stage.skippedShare ? fmt::format(", {:.0f} % skipped", 100.0 * *stage.skippedShare) : "";
}

std::string timingsText(const DenoiseReport& report) {
  const Timings& timings = *report.timings;
  std::string text = fmt::format("\n  {:<32}{:>9}{:>9}{:>9}{:>9}{:>8}",
                                 fmt::format("stage ({} time, ms)", toString(timings.source)), "median",
                                 "min", "max", "MB", "GB/s");
  if (report.copyMs) text += fmt::format("{:>8}{:>9}", "copies", "of copy");
  text += "\n";
  for (const StageTimings& stage : timings.stages)
    text += rowText(stage.label + skippedText(stage), stage.time, stage.bytesMoved, report);
  const StageTimings sum = sumOfStages(timings);
  text += rowText(sum.stage, sum.time, sum.bytesMoved, report);
  text += rowText("frame, gaps included", timings.frame, sum.bytesMoved, report);
  if (report.copyMs)
    text +=
        fmt::format("  one copy (22.1 MB at {:.1f} GB/s) takes {:.3f} ms\n", *report.copyGbs, *report.copyMs);
  return text;
}

// Characters of a metric's column; its values have up to four digits before the point.
int columnWidth(const metrics::Metric& metric) {
  constexpr int kLeast = 9, kGap = 2;
  return std::max(kLeast, static_cast<int>(std::strlen(metric.column)) + kGap);
}

constexpr int kReferenceWidth = 13;  // characters

std::string figuresText(const std::string& name, const metrics::ErrorFigures& figures,
                        io::ReferenceKind reference) {
  std::string line = fmt::format("  {:<24}", name);
  for (std::size_t i = 0; i < figures.values.size(); ++i) {
    const metrics::Metric& metric = metrics::imageMetrics()[i];
    line += fmt::format("{:>{}}", fixed(figures.values[i], metric.digits, "-"), columnWidth(metric));
  }
  return line + fmt::format("{:>{}}\n", toString(reference), kReferenceWidth);
}

std::string errorsText(const std::vector<FrameErrors>& errors) {
  std::string lines = fmt::format("\n  {:<24}", "error");
  for (const metrics::Metric& metric : metrics::imageMetrics())
    lines += fmt::format("{:>{}}", metric.column, columnWidth(metric));
  lines += fmt::format("{:>{}}\n", "reference", kReferenceWidth);
  for (const FrameErrors& frame : errors) {
    lines += figuresText(fmt::format("frame {} noisy input", frame.frame), frame.noisy, frame.reference);
    lines += figuresText(fmt::format("frame {} denoised", frame.frame), frame.linear, frame.reference);
    lines += figuresText(fmt::format("frame {} display", frame.frame), frame.display, frame.reference);
  }
  return lines;
}

}  // namespace

FrameErrors compareFrame(const io::FrameData& frame, const DenoisedFrame& denoised,
                         const io::Reference& reference) {
  return {frame.number, metrics::compareToReference(frame.noisy(), false, reference.a, reference.b),
          metrics::compareToReference(denoised.linear, false, reference.a, reference.b),
          metrics::compareToReference(denoised.display, true, reference.a, reference.b, denoised.transform),
          reference.kind};
}

metrics::TrackedFrame trackFrame(const io::FrameData& frame, const DenoisedFrame& denoised) {
  return {metrics::encodeForDisplay(denoised.linear),
          frame.normalWorld,
          frame.positionWorld,
          frame.camera,
          frame.motion,
          frame.objectId,
          frame.afterGap};
}

StageTimings sumOfStages(const Timings& timings) {
  StageTimings sum;
  sum.stage = "sum of stages";
  for (const StageTimings& stage : timings.stages) {
    sum.time.count = stage.time.count;
    sum.time.medianMs += stage.time.medianMs;
    sum.time.meanMs += stage.time.meanMs;
    sum.time.minMs += stage.time.minMs;
    sum.time.maxMs += stage.time.maxMs;
    sum.bytesMoved += stage.bytesMoved;
  }
  return sum;
}

double gigabytesPerSecond(std::uint64_t bytes, const TimeStatistics& time) {
  return time.medianMs > 0.0 ? static_cast<double>(bytes) * 1e-6 / time.medianMs : 0.0;
}

const char* toString(TimeSource source) { return source == TimeSource::Device ? "device" : "host"; }

json toJson(const DenoiseReport& report) {
  json result = {{"device", report.device.name},
                 {"driver", report.device.driverVersion},
                 {"method", report.settings.method()},
                 {"settings", settingsJson(report.settings)},
                 {"width", report.size.width},
                 {"height", report.size.height},
                 {"frames", report.frames},
                 {"memory_bytes", report.memory.totalBytes},
                 {"output_hash", report.outputHash}};
  if (report.timings) result.update(toJson(*report.timings));
  if (report.copyMs) {
    result["copy_ms"] = *report.copyMs;
    result["copy_gbs"] = *report.copyGbs;
  }
  if (report.temporalError) result[metrics::kTemporalError.key] = number<json>(report.temporalError);
  if (!report.errors.empty()) result["errors"] = json::array();
  for (const FrameErrors& frame : report.errors) {
    result["errors"].push_back({{"frame", frame.frame},
                                {"linear_reference", toString(frame.reference)},
                                {"display_reference", toString(frame.reference)},
                                {"noisy", figuresJson(frame.noisy)},
                                {"linear", figuresJson(frame.linear)},
                                {"display", figuresJson(frame.display)}});
  }
  return result;
}

std::string toText(const DenoiseReport& report) {
  std::string text = fmt::format("{}, {} frame{} of {}x{} on {} (driver {})\n", report.settings.method(),
                                 report.frames, report.frames == 1 ? "" : "s", report.size.width,
                                 report.size.height, report.device.name, report.device.driverVersion);
  text += fmt::format("device memory {:.1f} MiB, output hash {}\n", mebibytes(report.memory.totalBytes),
                      report.outputHash);
  if (report.timings) text += timingsText(report);
  if (!report.errors.empty()) text += errorsText(report.errors);
  if (report.temporalError)
    text += fmt::format("  {}, motion-compensated (mean luma difference of consecutive frames): {:.{}f}\n",
                        metrics::kTemporalError.label, *report.temporalError, metrics::kTemporalError.digits);
  return text;
}

void print(const DenoiseReport& report) { fmt::print("{}", toText(report)); }

}  // namespace quell::cli
