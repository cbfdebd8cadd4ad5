#include "host/api/denoiser_implementation.hpp"

#include <algorithm>
#include <utility>

#include "host/core/cl_error.hpp"
#include "host/core/frame_images.hpp"
#include "host/core/handle_checks.hpp"
#include "host/core/memory_checks.hpp"
#include "host/core/reprojection.hpp"
#include "host/core/validation.hpp"
#include "host/core/warm_up.hpp"
#include "host/stages/f_beta_table.hpp"

namespace quell {
namespace {

constexpr char kFBetaTable[] = "fBetaTable";  // the port

cl_event retain(cl_event event) {
  clRetainEvent(event);
  return event;
}

/// View depth is found along rays from one point.
void requirePerspective(const Frame& frame, const char* function) {
  if (frame.viewDepth.present() && isOrthographic(frame.camera.worldToClip))
    throw Error(ErrorCode::InvalidArgument,
                {function, "viewDepth", "a perspective camera", "an orthographic one"});
}

}  // namespace

Denoiser::Implementation::Implementation(cl_context context, cl_device_id device, cl_command_queue queue,
                                         const Settings& settings, const Options& options)
    : m_context(context, true),
      m_device(device, true),
      m_queue(queue, true),
      m_cache(options.cacheDirectory ? *options.cacheDirectory : defaultCacheDirectory()),
      m_method(findMethod(settings.method())),
      m_configuration{{}, options, settings, {}, {}, m_method.runtimeSettings(settings)} {
  checkQueue(m_context, m_device, m_queue, options);
  m_configuration.device = queryDeviceTraits(m_device, options.mapping);
  m_outOfOrder = (m_queue.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE) != 0;
}

void Denoiser::Implementation::prepare(const Frame& frame, const Output& output) {
  unprepare();
  m_configuration = configurationFor(frame, output);
  if (frame.camera.worldToClip != Matrix4{}) requirePerspective(frame, "prepare");
  try {
    makeTables();
    m_pipeline = Pipeline(m_context, m_device, m_queue, m_cache, m_configuration, m_method.makeSchedule);
    warmUp();
  } catch (...) {
    unprepare();
    throw;
  }
  m_frameIndex = 0;
  m_prepared = true;
}

Configuration Denoiser::Implementation::configurationFor(const Frame& frame, const Output& output) const {
  checkLayout(frame, output);
  checkKinds("prepare", frame, output, m_device, m_context());
  Configuration configuration = m_configuration;
  configuration.frame = frame;
  configuration.output = output;
  resolveImageObjects(configuration.frame, configuration.output);
  requireFBetaImages(configuration);
  return configuration;
}

MemoryUse Denoiser::Implementation::memoryNeeded(const Frame& frame, const Output& output) const {
  Configuration configuration = configurationFor(frame, output);
  if (dividesByFBeta(configuration)) configuration.tables[kFBetaTable];  // the caller's runtime never sees it
  return Pipeline::memoryNeeded(m_cache, std::move(configuration), m_method.makeSchedule);
}

Event Denoiser::Implementation::denoise(const Frame& frame, const Output& output,
                                        const std::vector<cl_event>& waitList) {
  if (!m_prepared)
    throw Error(ErrorCode::NotPrepared, {"denoise", "", "a call of prepare() before", "none that succeeded"});
  checkSameLayout(m_configuration.frame, m_configuration.output, frame, output);
  checkNumbers("denoise", frame);
  checkMemory("denoise", frame, output, m_context());
  checkHalfPositions(frame);
  requirePerspective(frame, "denoise");
  const cl::Event last = record(frame, output, checkedEvents(waitList, m_context));
  return Event(retain(last()));
}

void Denoiser::Implementation::makeTables() {
  if (dividesByFBeta(m_configuration))
    m_configuration.tables[kFBetaTable] =
        FBetaTable(m_context, m_device, m_queue, m_configuration.device, m_cache, Shadowing::Separable)
            .buffer();
}

// Waits for frames in flight, since their memory is about to be given back, and drops all that prepare() made.
void Denoiser::Implementation::unprepare() {
  m_prepared = false;
  if (m_lastEvent() != nullptr) clWaitForEvents(1, &m_lastEvent());  // a failed frame is done, too
  m_lastEvent = cl::Event();
  m_frameIndex = 0;
  m_timer.reset();
  m_content = Content();
  m_contentKnown = false;
  m_pipeline = Pipeline();
  m_configuration.tables.clear();
}

// A frame that failed leaves no history, and nothing may wait for it: that would fail as well.
void Denoiser::Implementation::forgetFailedFrame() {
  if (m_events.takeFailed()) m_frameIndex = 0;
  if (!hasFailed(m_lastEvent)) return;
  m_lastEvent = cl::Event();
  m_frameIndex = 0;
}

cl::Event Denoiser::Implementation::record(const Frame& frame, const Output& output,
                                           std::vector<cl::Event> waitFor) {
  forgetFailedFrame();
  const bool historyValid = m_frameIndex > 0;
  Camera camera = frame.camera;
  if (camera.worldToClipPrev == Matrix4{}) camera.worldToClipPrev = m_latestFrame.camera.worldToClip;
  const ReprojectionParams reprojection = makeReprojectionParams(
      camera, frame.size, m_configuration.runtime.discard, historyValid, frame.motionScale);
  if (m_outOfOrder && m_lastEvent() != nullptr) waitFor.push_back(m_lastEvent);
  // On an in-order queue the chain carries on what a failing event of the wait list means for later kernels.
  const bool chain = m_outOfOrder || !waitFor.empty();
  FrameCommands commands(m_queue, std::move(waitFor), chain, m_timer != nullptr);
  try {
    m_pipeline.record(commands, frame, output, reprojection, m_frameIndex);
    m_queue.flush();  // hands the work to the device; does not wait
  } catch (...) {
    // Whatever was enqueued still runs: later frames come after it, and start afresh.
    if (commands.lastEvent()() != nullptr) m_lastEvent = commands.lastEvent();
    m_frameIndex = 0;
    if (chain) m_events.keep(commands.events());
    throw;
  }
  m_lastEvent = commands.lastEvent();
  m_latestFrame = frame;
  ++m_frameIndex;
  if (m_timer) {
    for (const auto& [stage, event] : commands.events()) m_timer->add(stage, event);
    m_timer->endFrame();
  }
  if (chain) m_events.keep(commands.events());
  return m_lastEvent;
}

// Machine code is often made at the first launch; nobody should wait for it in a frame.
void Denoiser::Implementation::warmUp() {
  const WarmUpImages images(m_context, m_queue, m_configuration.frame, m_configuration.output);
  m_frameIndex = 0;
  record(images.frame, images.output, {});
  m_queue.finish();
  startTimer();
}

}  // namespace quell
