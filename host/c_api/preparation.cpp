// Preparing, live changes, captures and replays in the C API.
#include <optional>
#include <quell/replay.hpp>
#include <string>

#include "host/c_api/boundary.hpp"
#include "host/c_api/frame.hpp"
#include "host/c_api/handles.hpp"

namespace quell::c_api {
namespace {

PrepareOptions toPrepareOptions(const quell_prepare_options* given, const char* function) {
  PrepareOptions options;
  if (given == nullptr) return options;
  const quell_prepare_options read = readStruct(given, function, "options");
  options.keepHistory = read.keepHistory != 0;
  if (read.settings != nullptr) options.settings = read.settings->settings;
  if (read.progress != nullptr)
    options.progress = [call = read.progress, user = read.user](const PrepareProgress& progress) {
      call(progress.stage.c_str(), progress.done, progress.total, user);
    };
  return options;
}

}  // namespace
}  // namespace quell::c_api

using namespace quell::c_api;

extern "C" {

quell_status quellPrepareWith(quell_denoiser* denoiser, const quell_frame* frame, const quell_output* output,
                              const quell_prepare_options* options) {
  return guarded("quellPrepareWith", [&] {
    require(denoiser, "quellPrepareWith", "denoiser");
    denoiser->denoiser.prepare(toFrame(frame, "quellPrepareWith"), toOutput(output, "quellPrepareWith"),
                               toPrepareOptions(options, "quellPrepareWith"));
  });
}

quell_status quellPrepareAsync(quell_denoiser* denoiser, const quell_frame* frame, const quell_output* output,
                               const quell_prepare_options* options) {
  return guarded("quellPrepareAsync", [&] {
    require(denoiser, "quellPrepareAsync", "denoiser");
    denoiser->denoiser.prepareAsync(toFrame(frame, "quellPrepareAsync"),
                                    toOutput(output, "quellPrepareAsync"),
                                    toPrepareOptions(options, "quellPrepareAsync"));
  });
}

quell_status quellIsReady(quell_denoiser* denoiser, int* ready) {
  return guarded("quellIsReady", [&] {
    require(denoiser, "quellIsReady", "denoiser");
    require(ready, "quellIsReady", "ready");
    *ready = denoiser->denoiser.isReady() ? 1 : 0;
  });
}

quell_status quellCancelPrepare(quell_denoiser* denoiser) {
  return guarded("quellCancelPrepare", [&] {
    require(denoiser, "quellCancelPrepare", "denoiser");
    denoiser->denoiser.cancelPrepare();
  });
}

quell_status quellCountStageKernels(quell_denoiser* denoiser, const quell_frame* frame,
                                    const quell_output* output, size_t* count) {
  return guarded("quellCountStageKernels", [&] {
    require(denoiser, "quellCountStageKernels", "denoiser");
    require(count, "quellCountStageKernels", "count");
    denoiser->kernels = denoiser->denoiser.kernelStates(toFrame(frame, "quellCountStageKernels"),
                                                        toOutput(output, "quellCountStageKernels"));
    *count = denoiser->kernels.size();
  });
}

quell_status quellGetStageKernel(const quell_denoiser* denoiser, size_t index, quell_stage_kernel* kernel) {
  return guarded("quellGetStageKernel", [&] {
    require(denoiser, "quellGetStageKernel", "denoiser");
    requireIndex(index, denoiser->kernels.size(), "quellGetStageKernel", "index");
    const quell::StageKernel& found = denoiser->kernels[index];
    writeStruct(kernel, {0, found.stage.c_str(), static_cast<quell_kernel_state>(found.state)},
                "quellGetStageKernel", "kernel");
  });
}

quell_status quellSetSettings(quell_denoiser* denoiser, const quell_settings* settings) {
  return guarded("quellSetSettings", [&] {
    require(denoiser, "quellSetSettings", "denoiser");
    require(settings, "quellSetSettings", "settings");
    denoiser->denoiser.setSettings(settings->settings);
  });
}

quell_status quellDenoiseOn(quell_denoiser* denoiser, cl_command_queue queue, const quell_frame* frame,
                            const quell_output* output, cl_uint waitCount, const cl_event* waitList,
                            cl_event* done) {
  return guarded("quellDenoiseOn", [&] {
    require(denoiser, "quellDenoiseOn", "denoiser");
    require(queue, "quellDenoiseOn", "queue");
    quell::Event event =
        denoiser->denoiser.denoise(toFrame(frame, "quellDenoiseOn"), toOutput(output, "quellDenoiseOn"),
                                   toEvents(waitCount, waitList, "quellDenoiseOn"), queue);
    if (done != nullptr) *done = event.release();
  });
}

quell_status quellGetCaptureState(quell_denoiser* denoiser, quell_capture_state* state) {
  return guarded("quellGetCaptureState", [&] {
    require(denoiser, "quellGetCaptureState", "denoiser");
    denoiser->capture = denoiser->denoiser.captureState();
    const quell::CaptureState& now = denoiser->capture;
    writeStruct(state, {0, now.directory.c_str(), now.problem.c_str(), now.frames}, "quellGetCaptureState",
                "state");
  });
}

quell_status quellReplay(const char* directory, cl_context context, cl_device_id device,
                         cl_command_queue queue, const char* cacheDirectory, quell_replay* replay) {
  return guarded("quellReplay", [&] {
    require(directory, "quellReplay", "directory");
    static thread_local std::string text;
    quell_replay all{0, 1, 0, 0, nullptr};
    std::string lines;
    std::optional<std::string> cache;
    if (cacheDirectory != nullptr) cache = cacheDirectory;
    for (const quell::Replay& one : quell::replay(directory, context, device, queue, cache)) {
      lines += quell::toText(one);
      all.equal = all.equal != 0 && one.equal() ? 1 : 0;
      all.frameCount += static_cast<int>(one.frames.size());
      all.differenceCount += static_cast<int>(one.differences.size());
    }
    text = std::move(lines);
    all.text = text.c_str();
    writeStruct(replay, all, "quellReplay", "replay");
  });
}

}  // extern "C"
