#include "host/cli/bench/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "host/cli/common/fair_rounds.hpp"
#include "host/cli/common/progress.hpp"
#include "host/measure/fma_rate.hpp"
#include "host/metrics/display_encoding.hpp"
#include "host/metrics/error.hpp"

namespace quell::cli {
namespace {

// Frames with the camera at rest after the warm-up where rounds keep the history: with those before, more than any
// method asks for before it takes the variance over time (settings temporalVarianceFrames).
constexpr int kSettlingFrames = 4;

// A run that was accepted, with its denoiser.
struct ActiveRun {
  BenchRun run;
  std::unique_ptr<DenoiseSession> session;
  OutputHash hash;
  metrics::MotionCompensatedErrorMeter flicker;
};

// Opens what the library accepts; notes what it refuses.
std::vector<ActiveRun> openRuns(const std::vector<PlannedRun>& plans, const BenchInput& input,
                                const DeviceArguments& device, std::vector<SkippedRun>& skipped) {
  const io::FrameSequence& sequence = *input.sequence;
  const Options options = makeOptions(device, TimerMode::Device);
  const Size size = {sequence.width(), sequence.height()};
  const io::FrameData example = sequence.read(input.frames.front());
  std::vector<ActiveRun> active;
  for (const PlannedRun& plan : plans) {
    try {
      const Settings settings = plan.settings(sequence);
      auto session = std::make_unique<DenoiseSession>(device.device, settings, options, example);
      DenoiseReport report;
      report.device = session->device();
      report.settings = settings;
      report.size = size;
      report.frames = input.frames.size();
      report.memory = session->denoiser().memoryUse();
      active.push_back({{sequence.name(), plan, std::move(report)}, std::move(session), {}, {}});
    } catch (const Error& error) {
      if (!isRefusal(error)) throw;
      skipped.push_back({sequence.name(), size, plan, error.what()});
      fmt::print("skipped on {}, {}x{}: {}: {}\n", sequence.name(), size.width, size.height, plan.name(),
                 error.what());
    }
  }
  return active;
}

// From the start of the first kernel to the end of the last; nothing where events carry no times.
std::optional<double> lastFrameMs(Denoiser& denoiser) {
  const Timings timings = denoiser.timings();
  if (timings.source != TimeSource::Device || timings.stages.empty()) return std::nullopt;
  constexpr double kMillisecondsPerNanosecond = 1e-6;
  return double(timings.stages.back().last.end - timings.stages.front().last.start) *
         kMillisecondsPerNanosecond;
}

// The last frame of an input that has a reference it can be compared with; -1 if none has.
int lastReferenceFrame(const BenchInput& input) {
  const io::References references(*input.sequence);
  for (auto frame = input.frames.rbegin(); frame != input.frames.rend(); ++frame)
    if (references.has(*frame) && input.sequence->read(*frame).comparable()) return *frame;
  return -1;
}

void keepInputPictures(std::vector<BenchPicture>& pictures, const BenchInput& input, int frame) {
  const std::string name = input.sequence->name();
  const io::FrameData data = input.sequence->read(frame);
  const io::Reference reference = *io::References(*input.sequence).of(frame);
  pictures.push_back({name, frame, "noisy", metrics::encodeForDisplay(data.noisy())});
  pictures.push_back(
      {name, frame, "reference", metrics::encodeForDisplay(metrics::meanOfHalves(reference.a, reference.b))});
}

void measureErrors(ActiveRun& active, const io::FrameData& frame, io::References& references,
                   int pictureFrame, bool wantsFlicker, std::vector<BenchPicture>& pictures) {
  const DenoisedFrame denoised = active.session->denoise(frame);
  active.hash.add(denoised.linear);
  active.hash.add(denoised.display);
  if (wantsFlicker) active.flicker.add(trackFrame(frame, denoised));
  if (frame.number == pictureFrame)
    pictures.push_back(
        {active.run.input, frame.number, active.run.plan.name(), metrics::encodeForDisplay(denoised.linear)});
  if (!frame.comparable()) return;
  if (const auto& reference = references.of(frame.number))
    active.run.report.errors.push_back(compareFrame(frame, denoised, *reference));
}

void warmUp(std::vector<ActiveRun>& active, const BenchInput& input, int pictureFrame,
            std::vector<BenchPicture>& pictures) {
  // A sweep without references is about time: at 3840x2160 the temporal error takes longer than all else.
  const bool hasReferences = lastReferenceFrame(input) >= 0;
  io::References references(*input.sequence);
  fairRound(active, input, 0, [&](ActiveRun& run, const io::FrameData& frame) {
    const bool wantsFlicker = hasReferences || run.run.plan.sweep.empty();
    measureErrors(run, frame, references, pictureFrame, wantsFlicker, pictures);
  });
  for (ActiveRun& run : active) {
    run.run.report.outputHash = run.hash.text();
    run.run.report.temporalError = run.flicker.mean();
    run.session->denoiser().clearTimings();
  }
}

void runTimed(ActiveRun& active, const io::FrameData& frame) {
  active.session->run(frame);
  if (const auto ms = lastFrameMs(active.session->denoiser())) active.run.frameMs.back().push_back(*ms);
}

// Fills the history: repeats the last frame with the camera at rest, untimed. Returns that camera.
Matrix4 settle(std::vector<ActiveRun>& active, const BenchInput& input) {
  io::FrameData frame = input.sequence->read(input.frames.back());
  frame.camera.worldToClipPrev = frame.camera.worldToClip;
  for (ActiveRun& run : active) {
    for (int i = 0; i < kSettlingFrames; ++i) run.session->run(frame);
    run.session->denoiser().clearTimings();
  }
  return frame.camera.worldToClip;
}

// A round that goes on with the history: odd ones from the last frame back to the first, even ones on to the last.
// `worldToClip`: the camera of the frame before, then of the last one run.
void runRoundOnwards(std::vector<ActiveRun>& active, const BenchInput& input, std::size_t round,
                     Matrix4& worldToClip) {
  const std::size_t count = input.frames.size();
  for (std::size_t i = 1; i < count; ++i) {
    io::FrameData frame = input.sequence->read(input.frames[round % 2 == 1 ? count - 1 - i : i]);
    frame.camera.worldToClipPrev = std::exchange(worldToClip, frame.camera.worldToClip);
    takeTurns(active, frame, round + i, runTimed);
  }
}

void runRounds(std::vector<ActiveRun>& active, const BenchInput& input, int rounds, bool keepsHistory,
               int pictureFrame, std::vector<BenchPicture>& pictures) {
  const std::string label = fmt::format("bench {} {}x{}", input.sequence->name(), input.sequence->width(),
                                        input.sequence->height());
  Progress progress(label, static_cast<std::size_t>(rounds) + 1);
  warmUp(active, input, pictureFrame, pictures);
  Matrix4 worldToClip = keepsHistory ? settle(active, input) : Matrix4{};
  progress.step("warm-up");
  for (int round = 1; round <= rounds; ++round) {
    for (ActiveRun& run : active) run.run.frameMs.emplace_back();
    const auto turn = static_cast<std::size_t>(round);
    if (keepsHistory)
      runRoundOnwards(active, input, turn, worldToClip);
    else
      fairRound(active, input, turn, runTimed);
    progress.step(fmt::format("round {}", round));
  }
  for (ActiveRun& run : active) run.run.report.timings = run.session->timings();
}

void measureBuilds(std::vector<ActiveRun>& active, const BenchInput& input, const DeviceArguments& device) {
  const io::FrameData example = input.sequence->read(input.frames.front());
  for (ActiveRun& run : active) run.run.build = measureBuildTimes(run.run.report.settings, device, example);
}

// All runs of a group on one of its inputs.
void runInput(BenchResult& result, const BenchGroup& group, const BenchInput& input,
              const BenchOptions& options, bool keepPictures, bool buildTimes) {
  std::vector<ActiveRun> active = openRuns(group.runs, input, options.device, result.skipped);
  if (active.empty()) return;
  const DenoiseSession& session = *active.front().session;
  if (options.fmaRate && result.fmaGigaflops == 0.0)
    result.fmaGigaflops = measureFmaRate(session.context(), session.deviceId(), session.queue());
  if (buildTimes) measureBuilds(active, input, options.device);
  const int pictureFrame = keepPictures ? lastReferenceFrame(input) : -1;
  if (pictureFrame >= 0) keepInputPictures(result.pictures, input, pictureFrame);
  result.copyMeasurements.push_back(measureCopy(session));
  runRounds(active, input, options.rounds, group.keepsHistory, pictureFrame, result.pictures);
  result.copyMeasurements.push_back(measureCopy(session));
  for (ActiveRun& run : active) result.runs.push_back(std::move(run.run));
}

}  // namespace

BenchResult runBench(const std::vector<BenchGroup>& groups, const BenchOptions& options) {
  BenchResult result;
  result.rounds = options.rounds;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t i = 0; i < groups[g].inputs.size(); ++i) {
      const bool first = g == 0;
      runInput(result, groups[g], groups[g].inputs[i], options,
               first && i < static_cast<std::size_t>(options.pictureInputs),
               first && i == 0 && options.buildTimes);
    }
  }
  if (result.runs.empty())
    refuse("bench", "settings", "a combination that the library accepts", result.skipped.front().reason);
  result.copy = mean(result.copyMeasurements);
  for (BenchRun& run : result.runs) {
    run.report.copyMs = result.copy.copyMs;
    run.report.copyGbs = result.copy.gigabytesPerSecond;
  }
  return result;
}

}  // namespace quell::cli
