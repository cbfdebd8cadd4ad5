#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "host/c_api/boundary.hpp"
#include "host/c_api/frame.hpp"
#include "host/c_api/handles.hpp"

namespace quell::c_api {
namespace {

quell_time_statistics toC(const TimeStatistics& time) {
  return {time.count, time.medianMs, time.meanMs, time.minMs, time.maxMs};
}

quell_stage_timings toC(const StageTimings& stage) {
  const StageEventTimes& last = stage.last;
  return {0,
          stage.stage.c_str(),
          toC(stage.time),
          last.queued,
          last.submit,
          last.start,
          last.end,
          stage.bytesMoved,
          stage.label.c_str(),
          stage.skippedShare ? 1 : 0,
          stage.skippedShare.value_or(0.0)};
}

}  // namespace
}  // namespace quell::c_api

using namespace quell::c_api;

extern "C" {

quell_status quellCreateDenoiser(cl_context context, cl_device_id device, cl_command_queue queue,
                                 const quell_settings* settings, const quell_options* options,
                                 quell_denoiser** denoiser) {
  return guarded("quellCreateDenoiser", [&] {
    require(denoiser, "quellCreateDenoiser", "denoiser");
    quell::Denoiser made(context, device, queue, settings == nullptr ? quell::Settings() : settings->settings,
                         toOptions(options, "quellCreateDenoiser"));
    *denoiser = new quell_denoiser{std::move(made), {}, {}, {}, {}};
  });
}

void quellDestroyDenoiser(quell_denoiser* denoiser) { delete denoiser; }

quell_status quellPrepare(quell_denoiser* denoiser, const quell_frame* frame, const quell_output* output) {
  return guarded("quellPrepare", [&] {
    require(denoiser, "quellPrepare", "denoiser");
    denoiser->denoiser.prepare(toFrame(frame, "quellPrepare"), toOutput(output, "quellPrepare"));
  });
}

quell_status quellDenoise(quell_denoiser* denoiser, const quell_frame* frame, const quell_output* output,
                          cl_uint waitCount, const cl_event* waitList, cl_event* done) {
  return guarded("quellDenoise", [&] {
    require(denoiser, "quellDenoise", "denoiser");
    quell::Event event =
        denoiser->denoiser.denoise(toFrame(frame, "quellDenoise"), toOutput(output, "quellDenoise"),
                                   toEvents(waitCount, waitList, "quellDenoise"));
    if (done != nullptr) *done = event.release();
  });
}

quell_status quellResetHistory(quell_denoiser* denoiser) {
  return guarded("quellResetHistory", [&] {
    require(denoiser, "quellResetHistory", "denoiser");
    denoiser->denoiser.resetHistory();
  });
}

quell_status quellGetDenoiserSettings(const quell_denoiser* denoiser, quell_settings** settings) {
  return guarded("quellGetDenoiserSettings", [&] {
    require(denoiser, "quellGetDenoiserSettings", "denoiser");
    require(settings, "quellGetDenoiserSettings", "settings");
    *settings = new quell_settings{denoiser->denoiser.settings(), {}, {}};
  });
}

quell_status quellGetMemoryNeeded(quell_denoiser* denoiser, const quell_frame* frame,
                                  const quell_output* output, quell_memory_use* use) {
  return guarded("quellGetMemoryNeeded", [&] {
    require(denoiser, "quellGetMemoryNeeded", "denoiser");
    denoiser->memory = denoiser->denoiser.memoryNeeded(toFrame(frame, "quellGetMemoryNeeded"),
                                                       toOutput(output, "quellGetMemoryNeeded"));
    writeStruct(use, {0, denoiser->memory.totalBytes, denoiser->memory.buffers.size()},
                "quellGetMemoryNeeded", "use");
  });
}

quell_status quellGetMemoryUse(quell_denoiser* denoiser, quell_memory_use* use) {
  return guarded("quellGetMemoryUse", [&] {
    require(denoiser, "quellGetMemoryUse", "denoiser");
    denoiser->memory = denoiser->denoiser.memoryUse();
    writeStruct(use, {0, denoiser->memory.totalBytes, denoiser->memory.buffers.size()}, "quellGetMemoryUse",
                "use");
  });
}

quell_status quellGetBufferUse(const quell_denoiser* denoiser, size_t index, quell_buffer_use* use) {
  return guarded("quellGetBufferUse", [&] {
    require(denoiser, "quellGetBufferUse", "denoiser");
    requireIndex(index, denoiser->memory.buffers.size(), "quellGetBufferUse", "index");
    const quell::MemoryUse::Buffer& buffer = denoiser->memory.buffers[index];
    writeStruct(use, {0, buffer.name.c_str(), buffer.bytes}, "quellGetBufferUse", "use");
  });
}

quell_status quellGetTimings(quell_denoiser* denoiser, quell_timings* timings) {
  return guarded("quellGetTimings", [&] {
    require(denoiser, "quellGetTimings", "denoiser");
    denoiser->timings = denoiser->denoiser.timings();
    const quell::Timings& now = denoiser->timings;
    const bool device = now.source == quell::TimeSource::Device;
    writeStruct(timings, {0, device ? QUELL_TIME_DEVICE : QUELL_TIME_HOST, now.stages.size(), toC(now.frame)},
                "quellGetTimings", "timings");
  });
}

quell_status quellGetStageTimings(const quell_denoiser* denoiser, size_t index,
                                  quell_stage_timings* timings) {
  return guarded("quellGetStageTimings", [&] {
    require(denoiser, "quellGetStageTimings", "denoiser");
    requireIndex(index, denoiser->timings.stages.size(), "quellGetStageTimings", "index");
    writeStruct(timings, toC(denoiser->timings.stages[index]), "quellGetStageTimings", "timings");
  });
}

quell_status quellClearTimings(quell_denoiser* denoiser) {
  return guarded("quellClearTimings", [&] {
    require(denoiser, "quellClearTimings", "denoiser");
    denoiser->denoiser.clearTimings();
  });
}

}  // extern "C"
