#include "host/cli/bench_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "host/cli/denoise_session.hpp"
#include "host/cli/progress.hpp"

namespace quell::cli {
namespace {

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
      if (error.code() != ErrorCode::InvalidArgument && error.code() != ErrorCode::OutOfRange) throw;
      skipped.push_back({sequence.name(), size, plan, error.what()});
      fmt::print("skipped on {}, {}x{}: {}: {}\n", sequence.name(), size.width, size.height, plan.name(),
                 error.what());
    }
  }
  return active;
}

// Calls work(run, frame) for every frame and run; a round starts without history.
template <class Work>
void runRound(std::vector<ActiveRun>& active, const BenchInput& input, std::size_t round, const Work& work) {
  for (ActiveRun& run : active) run.session->denoiser().resetHistory();
  for (std::size_t i = 0; i < input.frames.size(); ++i) {
    const io::FrameData frame = input.sequence->read(input.frames[i]);
    for (std::size_t turn = 0; turn < active.size(); ++turn)
      work(active[(round + i + turn) % active.size()], frame);
  }
}

void measureErrors(ActiveRun& active, const io::FrameData& frame, const io::FrameSequence& sequence) {
  const DenoisedFrame denoised = active.session->denoise(frame);
  active.hash.add(denoised.linear);
  active.hash.add(denoised.display);
  active.flicker.add(trackFrame(frame, denoised));
  if (!frame.comparable()) return;
  if (const auto reference = sequence.reference(frame.number))
    active.run.report.errors.push_back(compareFrame(frame, denoised, *reference));
}

void warmUp(std::vector<ActiveRun>& active, const BenchInput& input) {
  runRound(active, input, 0,
           [&](ActiveRun& run, const io::FrameData& frame) { measureErrors(run, frame, *input.sequence); });
  for (ActiveRun& run : active) {
    run.run.report.outputHash = run.hash.text();
    run.run.report.temporalError = run.flicker.mean();
    run.session->denoiser().clearTimings();
  }
}

void runRounds(std::vector<ActiveRun>& active, const BenchInput& input, int rounds) {
  const std::string label = fmt::format("bench {} {}x{}", input.sequence->name(), input.sequence->width(),
                                        input.sequence->height());
  Progress progress(label, static_cast<std::size_t>(rounds) + 1);
  warmUp(active, input);
  progress.step("warm-up");
  for (int round = 1; round <= rounds; ++round) {
    runRound(active, input, static_cast<std::size_t>(round),
             [](ActiveRun& run, const io::FrameData& frame) { run.session->run(frame); });
    progress.step(fmt::format("round {}", round));
  }
  for (ActiveRun& run : active) run.run.report.timings = run.session->denoiser().timings();
}

CopyBandwidth measureCopy(const DenoiseSession& session) {
  return measureCopyBandwidth(session.context(), session.deviceId(), session.queue());
}

CopyBandwidth mean(const std::vector<CopyBandwidth>& measurements) {
  CopyBandwidth result;
  for (const CopyBandwidth& one : measurements)
    result.copyMs += one.copyMs / static_cast<double>(measurements.size());
  result.gigabytesPerSecond = kCopyBytes * 1e-6 / result.copyMs;
  return result;
}

}  // namespace

BenchResult runBench(const std::vector<PlannedRun>& runs, const std::vector<BenchInput>& inputs, int rounds,
                     const DeviceArguments& device) {
  BenchResult result;
  result.rounds = rounds;
  for (const BenchInput& input : inputs) {
    std::vector<ActiveRun> active = openRuns(runs, input, device, result.skipped);
    if (active.empty()) continue;
    result.copyMeasurements.push_back(measureCopy(*active.front().session));
    runRounds(active, input, rounds);
    result.copyMeasurements.push_back(measureCopy(*active.front().session));
    for (ActiveRun& run : active) result.runs.push_back(std::move(run.run));
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
