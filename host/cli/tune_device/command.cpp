// quell tune-device: which mapping and work-group suits each stage on this device, kept for all later runs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/analytic/sequence.hpp"
#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/commands.hpp"
#include "host/cli/common/denoise_session.hpp"
#include "host/cli/common/progress.hpp"
#include "host/core/device_traits.hpp"
#include "host/core/program_cache.hpp"
#include "host/core/tuning.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "tune-device";
// A candidate must beat the library's own choice by this share: less may be noise.
constexpr double kLeastGain = 0.05;

struct TuneOptions {
  std::vector<std::string> methods = methodNames();
  std::string device;
  std::string cacheDirectory;
  std::string size = "1280x720";
  int frames = 8;
  bool forget = false;
};

/// One way to run all stages.
struct Candidate {
  Mapping mapping;
  std::array<int, 2> workGroup;
  int fitGroup;
};

// Rows for coalescing, blocks for reuse in caches. `usual`, the library's own choice, comes first and last, so that
// drift of the machine shows.
std::vector<Candidate> candidates(const DeviceTraits& device) {
  const Mapping usual = device.lanes > 1 ? Mapping::Wide : Mapping::Narrow;
  std::vector<Candidate> all = {{usual, {0, 0}, 0}};
  for (const MappingFacts& facts : kMappings)
    if (facts.lanes > 0 && facts.lanes != device.lanes) all.push_back({facts.mapping, {0, 0}, 0});
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const std::array<int, 2> group :
         {std::array<int, 2>{1, 1}, {4, 1}, {16, 1}, {64, 1}, {256, 1}, {8, 8}, {32, 8}})
      all.push_back({mapping, group, 0});
    for (const int group : {4, 16, 64, 128, 256}) all.push_back({mapping, {0, 0}, group});
  }
  all.push_back(all.front());
  return all;
}

int lanesOf(Mapping mapping, const DeviceTraits& device) {
  return mapping == Mapping::Wide ? device.nativeLanes : factsOf(mapping).lanes;
}

std::string nameOf(const StageTuning& tuning) {
  std::string name = mappingWith(tuning.lanes)->name;
  if (tuning.workGroup[0] > 0) name += fmt::format(", {}x{}", tuning.workGroup[0], tuning.workGroup[1]);
  if (tuning.fitGroup > 0) name += fmt::format(", {} a block or tile", tuning.fitGroup);
  return name;
}

// Stage name -> its time with each candidate, summed over the methods, ms.
using StageTimes = std::map<std::string, std::vector<double>>;

// What pays; prints a line for every stage.
DeviceTuning choose(const StageTimes& times, const std::vector<Candidate>& all, const DeviceTraits& device) {
  DeviceTuning tuning;
  fmt::print("\n  {:<26}{:>10}{:>10}  {}\n", "stage (ms)", "usual", "best", "tuned to");
  for (const auto& [stage, ms] : times) {
    const double usual = std::min(ms.front(), ms.back());
    const auto best = static_cast<std::size_t>(std::min_element(ms.begin(), ms.end()) - ms.begin());
    const StageTuning found = {lanesOf(all[best].mapping, device), all[best].workGroup, all[best].fitGroup};
    const bool pays = ms[best] < usual * (1.0 - kLeastGain);
    if (pays) tuning[stage] = found;
    fmt::print("  {:<26}{:>10.3f}{:>10.3f}  {}\n", stage, usual, ms[best], pays ? nameOf(found) : "as it is");
  }
  return tuning;
}

// Adds the stages of a method under one candidate; stages of one name are taken together.
void addTimes(const TuneOptions& options, const std::string& method, const std::vector<io::FrameData>& frames,
              const std::vector<Candidate>& all, std::size_t candidate, StageTimes& times) {
  Options denoiser;
  denoiser.timers = TimerMode::Device;
  denoiser.mapping = all[candidate].mapping;
  denoiser.workGroup = all[candidate].workGroup;
  denoiser.fitGroup = all[candidate].fitGroup;
  denoiser.cacheDirectory = "";
  DenoiseSession session(options.device, Settings(method), denoiser, frames.front());
  for (const io::FrameData& frame : frames) session.run(frame);
  for (const StageTimings& stage : session.denoiser().timings().stages) {
    std::vector<double>& ms = times[stage.stage];
    ms.resize(all.size());
    ms[candidate] += stage.time.medianMs;
  }
}

DeviceTuning measure(const TuneOptions& options, const DeviceTraits& device) {
  io::AnalyticOptions analytic;
  const Size size = parseSize(kCommand, options.size);
  analytic.width = size.width;
  analytic.height = size.height;
  analytic.frameCount = options.frames;
  const auto sequence = io::makeAnalyticSequence(analytic);
  std::vector<io::FrameData> frames;  // read once: to make one up takes longer than to denoise it
  for (const int frame : sequence->frames()) frames.push_back(sequence->read(frame));
  const std::vector<Candidate> all = candidates(device);
  Progress progress(kCommand, options.methods.size() * all.size());
  StageTimes times;
  for (const std::string& method : options.methods) {
    for (std::size_t candidate = 0; candidate < all.size(); ++candidate) {
      addTimes(options, method, frames, all, candidate, times);
      progress.step(method);
    }
  }
  return choose(times, all, device);
}

void runTuneDevice(const TuneOptions& options) {
  const DeviceInfo info = chooseDevice(options.device);
  const DeviceTraits device = queryDeviceTraits(cl::Device(info.device, true), Mapping::Automatic);
  const std::string directory =
      options.cacheDirectory.empty() ? defaultCacheDirectory() : options.cacheDirectory;
  if (directory.empty())
    refuse(kCommand, "--cache-directory", "a directory, or XDG_CACHE_HOME or HOME", "none");
  const DeviceTuning tuning = options.forget ? DeviceTuning() : measure(options, device);
  writeTuning(DiskCache(directory), device.identity, tuning);
  fmt::print("{} of the stages are tuned for {} now; kept in {}\n", tuning.size(), info.name, directory);
}

}  // namespace

void addTuneDeviceCommand(CLI::App& app) {
  auto options = std::make_shared<TuneOptions>();
  CLI::App* command = app.add_subcommand(
      kCommand, "Measure which mapping and work-group suits each stage on this device; used from then on");
  command->add_option("--methods", options->methods, "Methods whose stages are measured")->delimiter(',');
  command->add_option("--device", options->device, "Index or part of a name, see 'quell devices'");
  command->add_option("--cache-directory", options->cacheDirectory, "Where compiled kernels are kept");
  command->add_option("--size", options->size, "Size of the built-in sequence")->capture_default_str();
  command->add_option("--frames", options->frames, "Frames that are timed with each choice")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--forget", options->forget, "Measure nothing, and run as everywhere from now on");
  command->callback([options] { runTuneDevice(*options); });
}

}  // namespace quell::cli
