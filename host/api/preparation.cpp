#include "host/api/preparation.hpp"

#include <chrono>
#include <quell/error.hpp>
#include <utility>

#include "host/core/cl_error.hpp"
#include "host/core/frame_images.hpp"
#include "host/core/frame_timer.hpp"
#include "host/core/history_transfer.hpp"
#include "host/stages/f_beta_table.hpp"

namespace quell {
namespace {

constexpr char kFBetaTable[] = "fBetaTable";  // the port

void throwIfCancelled(const std::atomic<bool>& cancelled, const std::string& when) {
  if (cancelled)
    throw Error(ErrorCode::NotPrepared, {"prepare", "", "time to finish", "cancelPrepare() " + when});
}

Pipeline::Progress reporting(const PrepareCallback& progress, const std::atomic<bool>& cancelled) {
  return [&progress, &cancelled](const std::string& stage, int done, int total) {
    if (progress) progress({stage, done, total});
    throwIfCancelled(cancelled, "after " + std::to_string(done) + " of " + std::to_string(total) + " steps");
  };
}

/// Looks again and again, since what it waits for may never come: a frame may wait for an event that the caller sets.
void waitFor(const cl::Event& event, const std::atomic<bool>& cancelled) {
  constexpr std::chrono::milliseconds kPause(1);
  if (event() == nullptr) return;
  // A failed frame is done, too.
  while (!cancelled && event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() > CL_COMPLETE)
    std::this_thread::sleep_for(kPause);
  throwIfCancelled(cancelled, "before the first step");
}

}  // namespace

void needTables(Configuration& configuration) {
  if (dividesByFBeta(configuration)) configuration.tables[kFBetaTable];
}

Prepared runPreparation(PreparationJob job, const std::atomic<bool>& cancelled) {
  const Pipeline::Progress progress = reporting(job.options.progress, cancelled);
  waitFor(job.former.last, cancelled);
  // Of our own: what the caller enqueues in the meantime neither waits nor is waited for.
  const cl::CommandQueue queue(job.context, job.device, job.queueProperties);
  const bool keep = job.options.keepHistory && job.former.frameIndex > 0;
  ProgramShelf held = job.former.pipeline.programs();  // what comes again is not compiled again
  if (!keep) job.former.pipeline = Pipeline();
  Configuration& configuration = job.configuration;
  needTables(configuration);
  for (auto& [name, table] : configuration.tables)
    table = FBetaTable(job.context, job.device, queue, configuration.device, job.cache, Shadowing::Separable)
                .buffer();
  Prepared made;
  made.pipeline = Pipeline(job.context, job.device, queue, job.cache, configuration, job.method->makeSchedule,
                           std::move(held), progress);
  made.deviceTimes = FrameTimer::hasDeviceTimes(made.pipeline.warmUp(job.context, queue, progress));
  if (keep && carryHistory(queue, job.former.pipeline, made.pipeline,
                           static_cast<int>((job.former.frameIndex - 1) % 2)))
    made.frameIndex = job.former.frameIndex;
  queue.finish();
  made.configuration = std::move(configuration);
  return made;
}

Preparation::Preparation(PreparationJob job, std::atomic<bool>& cancelled)
    : m_cancelled(cancelled), m_thread([this, moved = std::move(job)]() mutable { run(std::move(moved)); }) {}

Preparation::~Preparation() {
  m_cancelled = true;
  if (m_thread.joinable()) m_thread.join();
}

void Preparation::run(PreparationJob job) noexcept {
  try {
    job.options.progress = [this, given = job.options.progress](const PrepareProgress& progress) {
      {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_progress = progress;
      }
      if (given) given(progress);
    };
    m_result = withClErrors("prepare", [&] { return runPreparation(std::move(job), m_cancelled); });
  } catch (...) {
    m_failure = std::current_exception();
  }
  m_done = true;
}

std::string Preparation::state() const {
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_progress.total == 0) return "prepareAsync() is at its start";
  return "prepareAsync() is at step " + std::to_string(m_progress.done) + " of " +
         std::to_string(m_progress.total);
}

Prepared Preparation::take() {
  m_thread.join();
  if (m_failure) std::rethrow_exception(m_failure);
  return std::move(m_result);
}

}  // namespace quell
