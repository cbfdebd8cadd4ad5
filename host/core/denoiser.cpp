#include <algorithm>
#include <deque>
#include <mutex>
#include <quell/denoiser.hpp>
#include <utility>

#include "host/core/cl_error.hpp"
#include "host/core/f_beta_table.hpp"
#include "host/core/frame_images.hpp"
#include "host/core/frame_timer.hpp"
#include "host/core/image_schema.hpp"
#include "host/core/reprojection.hpp"
#include "host/core/schedule.hpp"
#include "host/core/stage.hpp"
#include "host/core/tuning.hpp"
#include "host/core/validation.hpp"
#include "host/methods/method.hpp"

namespace quell {
namespace {

void checkHandles(cl_context context, cl_device_id device, cl_command_queue queue) {
  const auto require = [](bool present, const char* name) {
    if (!present) throw Error(ErrorCode::InvalidArgument, {"Denoiser", name, "an OpenCL handle", "null"});
  };
  require(context != nullptr, "context");
  require(device != nullptr, "device");
  require(queue != nullptr, "queue");
}

void checkQueue(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue,
                const Options& options) {
  if (queue.getInfo<CL_QUEUE_CONTEXT>()() != context())
    throw Error(ErrorCode::WrongContext,
                {"Denoiser", "queue", "a queue of the given context", "another context's"});
  if (queue.getInfo<CL_QUEUE_DEVICE>()() != device())
    throw Error(ErrorCode::WrongContext,
                {"Denoiser", "queue", "a queue of the given device", "another device's"});
  const bool profiling = (queue.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_PROFILING_ENABLE) != 0;
  if (options.timers == TimerMode::Device && !profiling) {
    throw Error(ErrorCode::InvalidArgument,
                {"Denoiser", "options.timers", "a queue with CL_QUEUE_PROFILING_ENABLE for device timers",
                 "a queue without it"});
  }
}

void checkOptions(const Options& options) {
  const auto refuse = [](const char* name, const char* expected, int got) {
    throw Error(ErrorCode::InvalidArgument, {"Denoiser", name, expected, std::to_string(got)});
  };
  for (const int extent : options.workGroup)
    if (extent < 0) refuse("options.workGroup", "0 or a positive number of work-items", extent);
  const int group = options.fitGroup;
  if (group < 0 || group > 256 || (group & (group - 1)) != 0)
    refuse("options.fitGroup", "0 or a power of two up to 256", group);
}

/// True if the stage leaves out background, or finds it; see kernels/common/surfaces.h.
bool usesSurfaces(const StageRow& row) {
  return contains(row.reads, kSurfacesBuffer) || contains(row.writes, kSurfacesBuffer);
}

/// The kernels of one frame on their way into the queue; with `chain`, each waits for the one before.
class FrameCommands {
 public:
  FrameCommands(const cl::CommandQueue& queue, std::vector<cl::Event> waitFor, bool chain, bool keepEvents)
      : m_queue(queue), m_waitFor(std::move(waitFor)), m_chain(chain), m_keepEvents(keepEvents) {}

  /// `last`: of the frame's stages.
  void enqueue(std::size_t stage, bool last, const cl::Kernel& kernel, const cl::NDRange& range,
               const cl::NDRange& local) {
    const bool wantEvent = m_chain || m_keepEvents || last;
    cl::Event event;
    m_queue.enqueueNDRangeKernel(kernel, cl::NullRange, range, local,
                                 m_waitFor.empty() ? nullptr : &m_waitFor, wantEvent ? &event : nullptr);
    m_waitFor.clear();
    if (m_chain) m_waitFor.push_back(event);
    if (m_keepEvents || m_chain) m_events.emplace_back(stage, event);
    m_lastEvent = event;
  }

  const cl::Event& lastEvent() const { return m_lastEvent; }
  const std::vector<std::pair<std::size_t, cl::Event>>& events() const { return m_events; }

 private:
  const cl::CommandQueue& m_queue;
  std::vector<cl::Event> m_waitFor;
  bool m_chain;
  bool m_keepEvents;
  cl::Event m_lastEvent;
  std::vector<std::pair<std::size_t, cl::Event>> m_events;
};

/// What one stage sees of a frame that goes into the queue.
class StageRun : public FrameRun {
 public:
  StageRun(const Configuration& c, const Frame& f, const Output& o, const ReprojectionParams& r,
           std::uint32_t index, const BufferSet& buffers, FrameCommands& commands, std::size_t stage,
           bool last)
      : FrameRun(c, f, o, r, index), m_buffers(buffers), m_commands(commands), m_stage(stage), m_last(last) {}

  const cl::Buffer& buffer(const std::string& name) const override {
    return m_buffers.get(name, static_cast<int>(frameIndex % 2));
  }

 protected:
  void enqueue(const cl::Kernel& kernel, std::array<std::size_t, 2> global,
               const cl::NDRange& local) override {
    const auto padded = [](std::size_t items, std::size_t group) {
      return (items + group - 1) / group * group;
    };
    m_commands.enqueue(m_stage, m_last, kernel,
                       cl::NDRange(padded(global[0], local[0]), padded(global[1], local[1])), local);
  }

 private:
  const BufferSet& m_buffers;
  FrameCommands& m_commands;
  std::size_t m_stage;
  bool m_last;
};

using EventChain = std::vector<std::pair<std::size_t, cl::Event>>;

/// Keeps the chains of frames that have failed, or are still pending when their denoiser goes; see keepUntilDone().
void outliveDenoiser(std::deque<EventChain> chains) noexcept {
  static std::mutex mutex;
  static auto* const kept =
      new std::deque<EventChain>;  // never destroyed: a runtime may outlive static objects
  try {
    const std::lock_guard<std::mutex> lock(mutex);
    const auto isDone = [](const EventChain& chain) {
      return chain.back().second.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() == CL_COMPLETE;
    };
    kept->erase(std::remove_if(kept->begin(), kept->end(), isDone), kept->end());
    for (EventChain& chain : chains)
      if (!isDone(chain)) kept->push_back(std::move(chain));
  } catch (...) {
    // Nothing that a caller could do about it.
  }
}

/// Stand-ins for the caller's images while kernels are launched for the first time.
class WarmUpImages {
 public:
  WarmUpImages(const cl::Context& context, const cl::CommandQueue& queue, const Frame& layout,
               const Output& outputLayout)
      : frame(layout), output(outputLayout) {
    for (const auto& image : kInputs<Frame>) provide(context, queue, frame.*image.member);
    for (const auto& image : kOutputs<Output>) provide(context, queue, output.*image.member);
    // Any camera will do; this one looks along -z.
    frame.camera.worldToClip = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -1, 0};
    frame.camera.worldToClipPrev = frame.camera.worldToClip;
  }

  Frame frame;
  Output output;

 private:
  void provide(const cl::Context& context, const cl::CommandQueue& queue, ImageView& view) {
    if (!view.present()) return;
    const std::size_t bytes = view.requiredBytes(frame.size);
    m_buffers.emplace_back(context, CL_MEM_READ_WRITE, bytes);
    queue.enqueueFillBuffer(m_buffers.back(), cl_uchar(0), 0, bytes);
    view.memory = m_buffers.back()();
  }

  std::vector<cl::Buffer> m_buffers;
};

}  // namespace

class Denoiser::Implementation {
 public:
  Implementation(cl_context context, cl_device_id device, cl_command_queue queue, const Settings& settings,
                 const Options& options)
      : m_context(context, true),
        m_device(device, true),
        m_queue(queue, true),
        m_cache(options.cacheDirectory ? *options.cacheDirectory : defaultCacheDirectory()),
        m_method(findMethod(settings.method())),
        m_configuration{{}, options, settings, {}, {}} {
    checkQueue(m_context, m_device, m_queue, options);
    m_configuration.device = queryDeviceTraits(m_device, options.mapping);
    m_outOfOrder = (m_queue.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE) != 0;
  }

  ~Implementation() { outliveDenoiser(std::move(m_chains)); }

  void prepare(const Frame& frame, const Output& output) {
    unprepare();
    checkLayout(frame, output);
    if (frame.viewDepth.present() && isOrthographic(frame.camera.worldToClip) &&
        frame.camera.worldToClip != Matrix4{})
      throw Error(ErrorCode::InvalidArgument,
                  {"prepare", "viewDepth", "a perspective camera", "an orthographic one"});
    m_configuration.frame = frame;
    m_configuration.output = output;
    try {
      m_configuration.fBetaTable = makeFBetaTable();
      m_schedule = m_method.makeSchedule(m_configuration);
      buildStages();
      m_buffers = BufferSet(m_context, m_queue, m_schedule, frame.size);
      warmUp();
    } catch (...) {
      unprepare();
      throw;
    }
    m_frameIndex = 0;
    m_prepared = true;
  }

  Event denoise(const Frame& frame, const Output& output, const std::vector<cl_event>& waitList) {
    if (!m_prepared)
      throw Error(ErrorCode::NotPrepared,
                  {"denoise", "", "a call of prepare() before", "none that succeeded"});
    checkSameLayout(m_configuration.frame, m_configuration.output, frame, output);
    checkMemory(frame, output, m_context());
    checkHalfPositions(frame);
    if (frame.viewDepth.present() && isOrthographic(frame.camera.worldToClip))
      throw Error(ErrorCode::InvalidArgument,
                  {"denoise", "viewDepth", "a perspective camera", "an orthographic one"});
    const cl::Event last = record(frame, output, checkedEvents(waitList));
    return Event(retain(last()));
  }

  void resetHistory() { m_frameIndex = 0; }

  MemoryUse memoryUse() const { return m_buffers.memoryUse(); }

  Timings timings() {
    if (!m_timer) return {};
    Timings timings = m_timer->collect();
    for (std::size_t i = 0; i < timings.stages.size(); ++i)
      timings.stages[i].label = m_schedule.stages[i].stage->label();
    return timings;
  }

  void clearTimings() {
    if (m_timer) m_timer->clear();
  }

  const Settings& settings() const { return m_configuration.settings; }

  BackgroundMap backgroundMap() const {
    BackgroundMap map;
    for (const StageRow& row : m_schedule.stages)
      if (contains(row.reads, kSurfacesBuffer) && row.stage->name() != "background")
        map.stages.push_back(row.stage->label());
    if (map.stages.empty() || m_frameIndex == 0) return {};
    const auto [columns, rows] = pixelItems(m_configuration);
    map.itemWidth = m_configuration.device.lanes;
    map.columns = static_cast<int>(columns);
    map.rows = static_cast<int>(rows);
    map.background.resize(columns * rows);
    m_lastEvent.wait();  // a read that waited for a failed frame would never end on some runtimes
    m_queue.enqueueReadBuffer(m_buffers.get(kSurfacesBuffer, 0), CL_TRUE, 0, map.background.size(),
                              map.background.data());
    for (std::uint8_t& flag : map.background) flag = flag == 0 ? 1 : 0;
    return map;
  }

 private:
  void buildStages() {
    const DeviceTuning tuning = readTuning(m_cache.disk(), m_configuration.device.identity);
    m_stageConfigurations.clear();
    for (StageRow& row : m_schedule.stages) {
      m_stageConfigurations.push_back(m_configuration);
      Configuration& tuned = m_stageConfigurations.back();
      applyTuning(tuning, row.stage->name(), tuned);
      // One byte a work-item: stages that share them must agree on what a work-item is.
      if (usesSurfaces(row) && tuned.device.lanes != m_configuration.device.lanes) tuned = m_configuration;
      row.stage->build(DeviceKernelBuilder(m_context, m_device, m_cache, m_stageConfigurations.back()));
    }
  }

  cl::Buffer makeFBetaTable() const {
    if (!dividesByFBeta(m_configuration)) return {};
    return FBetaTable(m_context, m_device, m_queue, m_configuration.device, m_cache, Shadowing::Separable)
        .buffer();
  }

  static cl_event retain(cl_event event) {
    clRetainEvent(event);
    return event;
  }

  std::vector<cl::Event> checkedEvents(const std::vector<cl_event>& waitList) const {
    const auto refuse = [](ErrorCode code, const char* expected, const std::string& got) {
      throw Error(code, {"denoise", "waitList", expected, got});
    };
    std::vector<cl::Event> events;
    for (cl_event event : waitList) {
      if (event == nullptr) refuse(ErrorCode::InvalidArgument, "events", "a null event");
      events.emplace_back(event, true);
      if (events.back().getInfo<CL_EVENT_CONTEXT>()() != m_context())
        refuse(ErrorCode::WrongContext, "events of the denoiser's context", "one of another context");
      // Commands that wait for an event that has failed already never end on some runtimes (PoCL 3.1).
      const cl_int status = events.back().getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>();
      if (status < 0)
        refuse(ErrorCode::DeviceError, "events that have not failed",
               "one with status " + clErrorName(status));
    }
    return events;
  }

  // Waits for frames in flight, since their memory is about to be given back, and drops all that prepare()
  // made.
  void unprepare() {
    m_prepared = false;
    if (m_lastEvent() != nullptr) clWaitForEvents(1, &m_lastEvent());  // a failed frame is done, too
    m_lastEvent = cl::Event();
    m_frameIndex = 0;
    m_timer.reset();
    m_schedule = Schedule();
    m_stageConfigurations.clear();
    m_buffers = BufferSet();
    m_configuration.fBetaTable = cl::Buffer();
  }

  // A frame that failed leaves no history, and nothing may wait for it: that would fail as well.
  void forgetFailedFrame() {
    const auto failed = [](const cl::Event& event) {
      return event() != nullptr && event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() < 0;
    };
    const auto firstFailed =
        std::stable_partition(m_chains.begin(), m_chains.end(),
                              [&](const EventChain& chain) { return !failed(chain.back().second); });
    if (firstFailed != m_chains.end()) {
      m_frameIndex = 0;
      outliveDenoiser({firstFailed, m_chains.end()});
      m_chains.erase(firstFailed, m_chains.end());
    }
    if (!failed(m_lastEvent)) return;
    m_lastEvent = cl::Event();
    m_frameIndex = 0;
  }

  cl::Event record(const Frame& frame, const Output& output, std::vector<cl::Event> waitFor) {
    forgetFailedFrame();
    const bool historyValid = m_frameIndex > 0;
    const ReprojectionParams reprojection = makeReprojectionParams(
        frame.camera, frame.size, m_method.discardLimits(m_configuration.settings), historyValid);
    if (m_outOfOrder && m_lastEvent() != nullptr) waitFor.push_back(m_lastEvent);
    const bool keepEvents = m_timer != nullptr;
    // On an in-order queue the chain carries on what a failing event of the wait list means for later
    // kernels.
    const bool chain = m_outOfOrder || !waitFor.empty();
    FrameCommands commands(m_queue, std::move(waitFor), chain, keepEvents);
    try {
      for (std::size_t i = 0; i < m_schedule.stages.size(); ++i) {
        StageRun run(m_stageConfigurations[i], frame, output, reprojection, m_frameIndex, m_buffers, commands,
                     i, i + 1 == m_schedule.stages.size());
        m_schedule.stages[i].stage->enqueue(run);
      }
      m_queue.flush();  // hands the work to the device; does not wait
    } catch (...) {
      // Whatever was enqueued still runs: later frames come after it, and start afresh.
      if (commands.lastEvent()() != nullptr) m_lastEvent = commands.lastEvent();
      m_frameIndex = 0;
      if (chain) keepUntilDone(commands.events());
      throw;
    }
    m_lastEvent = commands.lastEvent();
    ++m_frameIndex;
    if (m_timer) {
      for (const auto& [stage, event] : commands.events()) m_timer->add(stage, event);
      m_timer->endFrame();
    }
    if (chain) keepUntilDone(commands.events());
    return m_lastEvent;
  }

  // Some runtimes touch events of a chain that fails after they have given them back (PoCL 3.1), so that references of
  // our own must outlast the failure.
  void keepUntilDone(const EventChain& events) {
    while (!m_chains.empty() &&
           m_chains.front().back().second.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() <= CL_COMPLETE)
      m_chains.pop_front();
    if (!events.empty()) m_chains.push_back(events);
  }

  // Machine code is often made at the first launch; nobody should wait for it in a frame.
  void warmUp() {
    const WarmUpImages images(m_context, m_queue, m_configuration.frame, m_configuration.output);
    m_frameIndex = 0;
    record(images.frame, images.output, {});
    m_queue.finish();
    startTimer();
  }

  void startTimer() {
    const TimerMode mode = m_configuration.options.timers;
    if (mode == TimerMode::Off) return;
    const bool device = mode == TimerMode::Device && FrameTimer::hasDeviceTimes(m_lastEvent);
    std::vector<std::string> names;
    std::vector<std::uint64_t> bytes;
    for (const StageRow& row : m_schedule.stages) {
      names.push_back(row.stage->name());
      bytes.push_back(bytesMoved(row));
    }
    m_timer = std::make_unique<FrameTimer>(std::move(names), std::move(bytes),
                                           device ? TimeSource::Device : TimeSource::Host);
  }

  std::uint64_t bytesMoved(const StageRow& row) const {
    std::uint64_t bytes = row.stage->callerBytes(m_configuration);
    for (const BufferSpec& spec : m_schedule.buffers) {
      for (const auto* names : {&row.reads, &row.writes})
        for (const std::string& name : *names)
          if (name == spec.name || name == spec.name + ".prev")
            bytes += payloadBytes(spec, m_configuration.size());
    }
    return bytes;
  }

  cl::Context m_context;
  cl::Device m_device;
  cl::CommandQueue m_queue;
  ProgramCache m_cache;
  const Method& m_method;
  Configuration m_configuration;
  Schedule m_schedule;
  std::vector<Configuration> m_stageConfigurations;  // as m_configuration, but tuned
  BufferSet m_buffers;
  std::unique_ptr<FrameTimer> m_timer;
  cl::Event m_lastEvent;
  std::deque<EventChain> m_chains;  // of frames that may still be pending
  std::uint32_t m_frameIndex = 0;
  bool m_outOfOrder = false;
  bool m_prepared = false;
};

Denoiser::Denoiser(cl_context context, cl_device_id device, cl_command_queue queue, const Settings& settings,
                   const Options& options) {
  checkHandles(context, device, queue);
  checkOptions(options);
  m_implementation = withClErrors("Denoiser", [&] {
    return std::make_unique<Implementation>(context, device, queue, settings, options);
  });
}

Denoiser::Denoiser(Denoiser&&) noexcept = default;
Denoiser& Denoiser::operator=(Denoiser&&) noexcept = default;
Denoiser::~Denoiser() = default;

void Denoiser::prepare(const Frame& frame, const Output& output) {
  withClErrors("prepare", [&] { m_implementation->prepare(frame, output); });
}

Event Denoiser::denoise(const Frame& frame, const Output& output, const std::vector<cl_event>& waitList) {
  return withClErrors("denoise", [&] { return m_implementation->denoise(frame, output, waitList); });
}

void Denoiser::resetHistory() { m_implementation->resetHistory(); }
MemoryUse Denoiser::memoryUse() const { return m_implementation->memoryUse(); }
Timings Denoiser::timings() {
  return withClErrors("timings", [&] { return m_implementation->timings(); });
}
void Denoiser::clearTimings() {
  withClErrors("clearTimings", [&] { m_implementation->clearTimings(); });
}
BackgroundMap Denoiser::backgroundMap() const {
  return withClErrors("backgroundMap", [&] { return m_implementation->backgroundMap(); });
}
const Settings& Denoiser::settings() const { return m_implementation->settings(); }

double BackgroundMap::share() const {
  const auto count = std::count(background.begin(), background.end(), std::uint8_t(1));
  return background.empty() ? 0.0 : static_cast<double>(count) / static_cast<double>(background.size());
}

Event& Event::operator=(Event&& other) noexcept {
  if (this != &other) {
    if (m_event != nullptr) clReleaseEvent(m_event);
    m_event = other.release();
  }
  return *this;
}

Event::~Event() {
  if (m_event != nullptr) clReleaseEvent(m_event);
}

void Event::wait() const {
  if (m_event == nullptr) return;
  const cl_int status = clWaitForEvents(1, &m_event);
  if (status != CL_SUCCESS) throw translateClError(status, "clWaitForEvents", "denoise");
}

}  // namespace quell
