#include "host/api/denoiser_implementation.hpp"

#include <utility>

#include "host/core/cl_error.hpp"
#include "host/core/frame_images.hpp"
#include "host/core/handle_checks.hpp"
#include "host/core/memory_checks.hpp"
#include "host/core/reprojection.hpp"
#include "host/core/validation.hpp"

namespace quell {
namespace {

cl_event retain(cl_event event) {
  clRetainEvent(event);
  return event;
}

bool isOutOfOrder(const cl::CommandQueue& queue) {
  return (queue.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE) != 0;
}

/// View depth is found along rays from one point.
void requirePerspective(const Frame& frame, const char* function) {
  if (frame.viewDepth.present() && isOrthographic(frame.camera.worldToClip))
    throw Error(ErrorCode::InvalidArgument,
                {function, "viewDepth", "a perspective camera", "an orthographic one"});
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

Denoiser::Implementation::Implementation(cl_context context, cl_device_id device, cl_command_queue queue,
                                         const Settings& settings, const Options& options)
    : m_context(context, true),
      m_device(device, true),
      m_queue(queue, true),
      m_cache(options.cacheDirectory ? *options.cacheDirectory : defaultCacheDirectory(),
              options.cacheDirectory.has_value()),
      m_method(findMethod(settings.method())),
      m_configuration{{}, options, settings, {}, {}, m_method.runtimeSettings(settings)} {
  checkQueue("Denoiser", m_context, m_device, m_queue, options);
  m_configuration.device = queryDeviceTraits(m_device, options.mapping);
}

void Denoiser::Implementation::prepare(const Frame& frame, const Output& output,
                                       const PrepareOptions& options) {
  adopt(runPreparation(jobFor(frame, output, options), m_cancelled));
}

void Denoiser::Implementation::prepareAsync(const Frame& frame, const Output& output,
                                            const PrepareOptions& options) {
  m_preparation = std::make_unique<Preparation>(jobFor(frame, output, options), m_cancelled);
}

bool Denoiser::Implementation::isReady() {
  if (m_preparation && m_preparation->done()) {
    const std::unique_ptr<Preparation> done = std::move(m_preparation);
    adopt(done->take());
  }
  return m_prepared;
}

// What is wrong with the arguments is thrown before anything is dropped, but leaves nothing prepared either.
PreparationJob Denoiser::Implementation::jobFor(const Frame& frame, const Output& output,
                                                const PrepareOptions& options) {
  m_preparation.reset();
  m_cancelled = false;
  m_historyIsKept = options.keepHistory;
  FormerFrames former = takeFormerFrames();
  if (options.settings) {
    const Configuration changed = configurationWith(*options.settings);
    m_configuration.settings = changed.settings;
    m_configuration.runtime = changed.runtime;
  }
  m_configuration = configurationFor(frame, output);
  if (frame.camera.worldToClip != Matrix4{}) requirePerspective(frame, "prepare");
  return {m_context,         m_device,  m_queue.getInfo<CL_QUEUE_PROPERTIES>(),
          m_cache,           &m_method, m_configuration,
          std::move(former), options};
}

// Events that are kept for frames that fail outlive all this.
FormerFrames Denoiser::Implementation::takeFormerFrames() {
  FormerFrames former{std::move(m_pipeline), m_lastEvent, m_prepared ? m_frameIndex : 0};
  m_prepared = false;
  m_lastEvent = cl::Event();
  m_frameIndex = 0;
  m_timer.reset();
  m_content = Content();
  m_contentKnown = false;
  m_pipeline = Pipeline();
  m_configuration.tables.clear();
  return former;
}

void Denoiser::Implementation::adopt(Prepared prepared) {
  m_configuration = std::move(prepared.configuration);
  m_pipeline = std::move(prepared.pipeline);
  m_frameIndex = m_historyIsKept ? prepared.frameIndex : 0;
  startTimer(prepared.deviceTimes);
  m_capture.reset();  // what is complete is written first
  const std::string captures = captureDirectory(m_configuration.options);
  if (!captures.empty()) m_capture = std::make_unique<Capture>(captures, m_pipeline.configuration());
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

Configuration Denoiser::Implementation::configurationWith(const Settings& settings) const {
  if (settings.method() != m_method.name)
    throw Error(
        ErrorCode::InvalidArgument,
        {"setSettings", "method", m_method.name + ", as the denoiser was made with", settings.method()});
  Configuration configuration = m_configuration;
  configuration.settings = settings;
  configuration.runtime = m_method.runtimeSettings(settings);
  return configuration;
}

MemoryUse Denoiser::Implementation::memoryNeeded(const Frame& frame, const Output& output) const {
  Configuration configuration = configurationFor(frame, output);
  needTables(configuration);
  return Pipeline::memoryNeeded(m_cache, std::move(configuration), m_method.makeSchedule);
}

std::vector<StageKernel> Denoiser::Implementation::kernelStates(const Frame& frame,
                                                                const Output& output) const {
  Configuration configuration = configurationFor(frame, output);
  needTables(configuration);
  return Pipeline::kernelStates(m_pipeline, m_cache, std::move(configuration), m_method.makeSchedule);
}

void Denoiser::Implementation::setSettings(const Settings& settings) {
  const Configuration changed = configurationWith(settings);
  const std::vector<std::string> names = settingsToPrepare(settings);
  if (!names.empty())
    throw Error(ErrorCode::NotPrepared,
                {"setSettings", joined(names), "settings that need no prepare()",
                 "some whose kernels or buffers are others (PrepareOptions::settings takes them)"});
  if (m_prepared) m_pipeline.retune(changed, m_method.makeSchedule, m_context, m_device, m_cache);
  m_configuration.settings = changed.settings;
  m_configuration.runtime = changed.runtime;
}

std::vector<std::string> Denoiser::Implementation::settingsToPrepare(const Settings& settings) const {
  const Configuration changed = configurationWith(settings);
  const auto serves = [&](const Configuration& configuration) {
    return m_pipeline.serves(configuration, m_method.makeSchedule);
  };
  if (!m_prepared || serves(changed)) return {};
  std::vector<std::string> different, alone;
  for (const SettingDescription& setting : settings.descriptions()) {
    const std::string value = settings.text(setting.name);
    if (value == m_configuration.settings.text(setting.name)) continue;
    different.push_back(setting.name);
    Settings one = m_configuration.settings;
    one.set(setting.name, value);
    if (!serves(configurationWith(one))) alone.push_back(setting.name);
  }
  return alone.empty() ? different : alone;
}

Event Denoiser::Implementation::denoise(const Frame& frame, const Output& output,
                                        const std::vector<cl_event>& waitList, cl_command_queue givenQueue) {
  if (!isReady())
    throw Error(ErrorCode::NotPrepared, {"denoise", "", "a call of prepare() before",
                                         m_preparation ? m_preparation->state() : "none that succeeded"});
  const cl::CommandQueue queue = queueFor(givenQueue);
  checkSameLayout(m_configuration.frame, m_configuration.output, frame, output);
  checkNumbers("denoise", frame);
  checkMemory("denoise", frame, output, m_context());
  checkHalfPositions(frame);
  requirePerspective(frame, "denoise");
  std::vector<cl::Event> waitFor = checkedEvents(waitList, m_context);
  forgetFailedFrame();
  if (m_lastEvent() != nullptr &&
      (isOutOfOrder(queue) || m_lastEvent.getInfo<CL_EVENT_COMMAND_QUEUE>()() != queue()))
    waitFor.push_back(m_lastEvent);
  const bool captured = m_capture && m_capture->takesNext();
  const cl::Event last = captured ? recordCaptured(queue, frame, output, std::move(waitFor))
                                  : record(queue, frame, output, std::move(waitFor));
  return Event(retain(last()));
}

cl::CommandQueue Denoiser::Implementation::queueFor(cl_command_queue given) const {
  if (given == nullptr || given == m_queue()) return m_queue;
  cl::CommandQueue queue(given, true);
  checkQueue("denoise", m_context, m_device, queue, m_configuration.options);
  return queue;
}

// A frame that failed leaves no history, and nothing may wait for it: that would fail as well.
void Denoiser::Implementation::forgetFailedFrame() {
  if (m_events.takeFailed()) m_frameIndex = 0;
  if (!hasFailed(m_lastEvent)) return;
  m_lastEvent = cl::Event();
  m_frameIndex = 0;
}

Camera Denoiser::Implementation::withPrevious(Camera camera) const {
  if (camera.worldToClipPrev == Matrix4{}) camera.worldToClipPrev = m_latestFrame.camera.worldToClip;
  return camera;
}

cl::Event Denoiser::Implementation::recordCaptured(const cl::CommandQueue& queue, const Frame& frame,
                                                   const Output& output, std::vector<cl::Event> waitFor) {
  const Camera camera = withPrevious(frame.camera);
  m_capture->readInputs(queue, frame, output,
                        {m_configuration.settings, m_frameIndex, camera.worldToClipPrev}, m_pipeline,
                        waitFor);
  try {
    m_lastEvent = m_capture->readOutputs(queue, record(queue, frame, output, std::move(waitFor)));
  } catch (...) {
    m_capture->dropFrame();
    m_events.keep(m_capture->events());
    throw;
  }
  m_events.keep(m_capture->events());
  return m_lastEvent;
}

cl::Event Denoiser::Implementation::record(const cl::CommandQueue& queue, const Frame& frame,
                                           const Output& output, std::vector<cl::Event> waitFor) {
  const ReprojectionParams reprojection =
      makeReprojectionParams(withPrevious(frame.camera), frame.size, m_configuration.runtime.discard,
                             m_frameIndex > 0, frame.motionScale);
  // On an in-order queue the chain carries on what a failing event of the wait list means for later kernels.
  const bool chain = isOutOfOrder(queue) || !waitFor.empty();
  FrameCommands commands(queue, std::move(waitFor), chain, m_timer != nullptr);
  try {
    m_pipeline.record(commands, frame, output, reprojection, m_frameIndex);
    queue.flush();  // hands the work to the device; does not wait
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

}  // namespace quell
