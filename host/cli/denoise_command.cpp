// quell denoise: a sequence in, denoised frames, times and errors out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "bench/copy_bandwidth.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/denoise_report.hpp"
#include "host/cli/denoise_session.hpp"
#include "host/cli/output_files.hpp"
#include "host/cli/progress.hpp"
#include "host/io/analytic_sequence.hpp"
#include "host/io/atomic_file.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::cli {
namespace {

struct DenoiseOptions {
  std::string method = "bmfr";
  std::string input;
  std::string output;
  std::string frames;
  std::string device;
  std::string size = "1280x720";
  std::string taa;
  std::string timers = "device";
  std::string mapping = "automatic";
  std::string json;
  std::string cacheDirectory;
  std::vector<std::string> settings;
  int analyticFrames = 16;
  bool noCache = false;
  bool png = false;
  bool exr = false;
  bool copyBandwidth = false;
};

[[noreturn]] void refuse(const char* option, const std::string& expected, const std::string& got) {
  throw Error(ErrorCode::InvalidArgument, {"denoise", option, expected, got});
}

// "AxB" or "A-B" as two whole numbers.
std::pair<int, int> parsePair(const char* option, const std::string& text, char separator,
                              const char* expected) {
  const std::size_t split = text.find(separator);
  try {
    std::size_t used = 0;
    const int first = std::stoi(text.substr(0, split), &used);
    if (used != (split == std::string::npos ? text.size() : split)) refuse(option, expected, text);
    if (split == std::string::npos) return {first, first};
    const int second = std::stoi(text.substr(split + 1), &used);
    if (used != text.size() - split - 1) refuse(option, expected, text);
    return {first, second};
  } catch (const std::logic_error&) {
    refuse(option, expected, text);
  }
}

std::unique_ptr<io::FrameSequence> openInput(const DenoiseOptions& options) {
  if (!options.input.empty()) return io::openSequence(options.input);
  const auto [width, height] = parsePair("--size", options.size, 'x', "a size such as 1280x720");
  io::AnalyticOptions analytic;
  analytic.width = width;
  analytic.height = height;
  analytic.frameCount = options.analyticFrames;
  return io::makeAnalyticSequence(analytic);
}

std::vector<int> chooseFrames(const DenoiseOptions& options, const io::FrameSequence& sequence) {
  std::vector<int> frames = sequence.frames();
  if (options.frames.empty()) return frames;
  const auto [first, last] = parsePair("--frames", options.frames, '-', "a range such as 0-15");
  const std::string present = fmt::format("a range within {}-{}", frames.front(), frames.back());
  if (first > last || first < frames.front() || last > frames.back())
    refuse("--frames", present, options.frames);
  frames.erase(
      std::remove_if(frames.begin(), frames.end(), [a = first, b = last](int f) { return f < a || f > b; }),
      frames.end());
  return frames;
}

Settings makeSettings(const DenoiseOptions& options, const io::FrameSequence& sequence) {
  Settings settings(options.method);
  if (const auto limits = sequence.historyLimits()) {
    // Published with the sequence, so better than any default; --set still wins.
    settings.set("positionLimit", std::sqrt(limits->positionSquared));
    settings.set("normalLimitSquared", limits->normalSquared);
  }
  if (!options.taa.empty()) settings.set("taa", options.taa);
  for (const std::string& assignment : options.settings) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) refuse("--set", "name=value", assignment);
    settings.set(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  return settings;
}

Options makeOptions(const DenoiseOptions& options) {
  Options result;
  result.timers = options.timers == "off"    ? TimerMode::Off
                  : options.timers == "host" ? TimerMode::Host
                                             : TimerMode::Device;
  result.mapping = options.mapping == "narrow" ? Mapping::Narrow
                   : options.mapping == "wide" ? Mapping::Wide
                                               : Mapping::Automatic;
  if (options.noCache) {
    result.cacheDirectory = "";
  } else if (!options.cacheDirectory.empty()) {
    result.cacheDirectory = options.cacheDirectory;
  }
  return result;
}

FrameErrors compareFrame(const io::FrameData& frame, const DenoisedFrame& denoised,
                         const io::Reference& reference) {
  return {frame.number, metrics::compareToReference(frame.radiance, false, reference.a, reference.b),
          metrics::compareToReference(denoised.linear, false, reference.a, reference.b),
          metrics::compareToReference(denoised.display, true, reference.a, reference.b)};
}

void runDenoise(const DenoiseOptions& options) {
  const std::unique_ptr<io::FrameSequence> sequence = openInput(options);
  const std::vector<int> frames = chooseFrames(options, *sequence);
  const Settings settings = makeSettings(options, *sequence);
  std::unique_ptr<OutputFiles> files;
  if (!options.output.empty())
    files = std::make_unique<OutputFiles>(options.output,
                                          OutputFormats{options.png || !options.exr, options.exr});

  io::FrameData frame = sequence->read(frames.front());
  DenoiseSession session(options.device, settings, makeOptions(options), frame);
  DenoiseReport report{
      session.device(), settings, {sequence->width(), sequence->height()}, 0, {}, "", {}, {}, {}, {}};
  OutputHash hash;
  Progress progress("denoise", frames.size());
  for (const int number : frames) {
    if (number != frame.number) frame = sequence->read(number);
    const DenoisedFrame denoised = session.denoise(frame);
    hash.add(denoised.linear);
    hash.add(denoised.display);
    if (files) files->write(number, denoised);
    if (const auto reference = sequence->reference(number)) {
      if (!frame.demodulated) report.errors.push_back(compareFrame(frame, denoised, *reference));
      if (files) files->writeComparison(frame, denoised, *reference);
    }
    ++report.frames;
    progress.step(fmt::format("frame {}", number));
  }

  report.memory = session.denoiser().memoryUse();
  report.outputHash = hash.text();
  if (options.timers != "off") report.timings = session.denoiser().timings();
  if (options.copyBandwidth) {
    const CopyBandwidth copy = measureCopyBandwidth(session.context(), session.deviceId(), session.queue());
    report.copyMs = copy.copyMs;
    report.copyGbs = copy.gigabytesPerSecond;
  }
  if (!options.json.empty()) io::writeTextFile(options.json, toJson(report).dump(2) + "\n");
  print(report);
  if (files) fmt::print("\npictures and frames are in {}\n", options.output);
}

std::string settingsHelp() {
  std::string text = "Settings for --set:\n";
  for (const std::string& method : methodNames()) {
    text += fmt::format("  {}: {}\n", method, methodSummary(method));
    const Settings defaults(method);
    for (const SettingDescription& setting : methodSettings(method)) {
      std::string range = fmt::format("{:g} to {:g}", setting.minimum, setting.maximum);
      if (setting.kind == SettingKind::Boolean) range = "on, off";
      if (setting.kind == SettingKind::Choice) range = fmt::format("{}", fmt::join(setting.choices, ", "));
      if (!setting.unit.empty()) range += " " + setting.unit;
      text += fmt::format("    {:<24} {} (default {}; {})\n", setting.name, setting.description,
                          defaults.text(setting.name), range);
    }
  }
  return text;
}

}  // namespace

void addDenoiseCommand(CLI::App& app) {
  auto options = std::make_shared<DenoiseOptions>();
  CLI::App* command = app.add_subcommand("denoise", "Denoise a frame sequence and report time and error");
  command->add_option("--method", options->method, "Method")
      ->check(CLI::IsMember(methodNames()))
      ->capture_default_str();
  command->add_option("--input", options->input,
                      "Directory with a sequence (see data/README.md); without it a built-in one is made up");
  command->add_option("--output", options->output,
                      "Directory for denoised_NNNN.exr and display_NNNN.png or .exr");
  command->add_option("--frames", options->frames, "Frames A-B; default: all");
  command->add_option("--device", options->device, "Index or part of a name, see 'quell devices'");
  command->add_option("--size", options->size, "Size of the built-in sequence")->capture_default_str();
  command->add_option("--frame-count", options->analyticFrames, "Length of the built-in sequence")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--taa", options->taa, "Temporal antialiasing of the display image")
      ->check(CLI::IsMember({"on", "off"}));
  command->add_option("--set", options->settings, "A setting of the method, name=value; may be repeated");
  command->add_option("--timers", options->timers, "Where stage times come from")
      ->check(CLI::IsMember({"device", "host", "off"}))
      ->capture_default_str();
  command
      ->add_option("--mapping", options->mapping,
                   "Pixels per work-item: 16 (wide), 1 (narrow), or what suits the device")
      ->check(CLI::IsMember({"automatic", "wide", "narrow"}))
      ->capture_default_str();
  command->add_option("--json", options->json, "File for the report as JSON");
  command->add_option("--cache-directory", options->cacheDirectory, "Where compiled kernels are kept");
  command->add_flag("--no-cache", options->noCache, "Keep no compiled kernels on disk");
  command->add_flag("--png", options->png, "Write display images as PNG (the default)");
  command->add_flag("--exr", options->exr, "Write display images as OpenEXR");
  command->add_flag("--copy-bandwidth", options->copyBandwidth,
                    "Also measure the device's copy bandwidth and report times in copies");
  command->footer(settingsHelp());
  command->callback([options] { runDenoise(*options); });
}

}  // namespace quell::cli
