#include "host/api/denoiser_implementation.hpp"

#include <utility>

#include "host/core/frame_images.hpp"
#include "host/core/handle_checks.hpp"
#include "host/core/memory_checks.hpp"
#include "host/core/validation.hpp"

namespace quell {
namespace {

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

// What is wrong with the arguments is thrown before anything changes.
PreparationJob Denoiser::Implementation::jobFor(const Frame& frame, const Output& output,
                                                const PrepareOptions& options) {
  Configuration wanted = configurationFor(
      options.settings ? configurationWith(*options.settings) : m_configuration, frame, output);
  wanted.tables.clear();
  if (frame.camera.worldToClip != Matrix4{}) checkPerspective("prepare", frame);
  m_preparation.reset();
  m_cancelled = false;
  m_historyIsKept = options.keepHistory;
  FormerFrames former = takeFormerFrames();
  m_configuration = std::move(wanted);
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

Configuration Denoiser::Implementation::configurationFor(Configuration configuration, const Frame& frame,
                                                         const Output& output) const {
  checkLayout(frame, output);
  checkKinds("prepare", frame, output, m_device, m_context());
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
  Configuration configuration = configurationFor(m_configuration, frame, output);
  needTables(configuration);
  return Pipeline::memoryNeeded(m_cache, std::move(configuration), m_method.makeSchedule);
}

std::vector<StageKernel> Denoiser::Implementation::kernelStates(const Frame& frame,
                                                                const Output& output) const {
  Configuration configuration = configurationFor(m_configuration, frame, output);
  needTables(configuration);
  return Pipeline::kernelStates(m_pipeline, m_cache, std::move(configuration), m_method.makeSchedule);
}

void Denoiser::Implementation::setSettings(const Settings& settings) {
  const Configuration changed = configurationWith(settings);
  const std::vector<std::string> names = settingsToPrepare(settings);
  if (!names.empty())
    throw Error(ErrorCode::NotPrepared, {"setSettings", joined(names), "settings that need no prepare()",
                                         "some that choose kernels or buffers: prepare() takes them in its "
                                         "options, which may keep the history"});
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

}  // namespace quell
