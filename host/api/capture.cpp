#include "host/api/capture.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <sstream>
#include <utility>

#include "host/api/captured_frame.hpp"
#include "host/api/captured_views.hpp"
#include "host/core/cl_error.hpp"
#include "host/core/render_rectangle.hpp"
#include "host/core/whole_file.hpp"

namespace quell {
namespace {

namespace fs = std::filesystem;

constexpr int kMostFolders = 9999;
constexpr std::chrono::seconds kMostWait(30);  // for a disk that is slow, not for one that hangs

/// A folder of the next number, which nobody else has taken.
std::string makeFolder(const fs::path& directory) {
  fs::create_directories(directory);
  for (int number = 1; number <= kMostFolders; ++number) {
    std::string name = std::to_string(number);
    name.insert(0, 4 - name.size(), '0');
    if (fs::create_directory(directory / name)) return (directory / name).string();
  }
  return "";
}

}  // namespace

/// Shared with what is written after the capture has gone.
struct Capture::Folder {
  mutable std::mutex mutex;
  CaptureState state;

  void fail(const std::string& problem) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (state.problem.empty()) state.problem = problem;
  }
};

/// A frame on its way into its file.
struct Capture::Shot {
  std::shared_ptr<Folder> folder;
  CapturedFrame frame;
  int number = 0;
  std::vector<Bytes> outputs;  // of each view; empty for inputs
  cl::Event last;
  std::mutex mutex;
  std::condition_variable changed;
  bool written = false;   // guarded
  bool complete = false;  // all reads are enqueued

  void write() noexcept;
  static void CL_CALLBACK onEnd(cl_event, cl_int status, void* data);
  static void writeAtEnd(const std::shared_ptr<Shot>& shot);
};

void Capture::Shot::write() noexcept {
  try {
    for (std::size_t i = 0; i < frame.views.size(); ++i)
      if (isOutput(frame.views[i]))
        frame.outputs.push_back({frame.views[i].name, pixelHash(frame.views[i], frame, outputs[i])});
    const std::string path = (fs::path(folder->state.directory) / frameFileName(number)).string();
    const std::string problem = writeFrame(path, frame);
    if (!problem.empty()) return folder->fail(path + " could not be written: " + problem);
    const std::lock_guard<std::mutex> lock(folder->mutex);
    ++folder->state.frames;
  } catch (const std::exception& exception) {
    folder->fail(exception.what());
  }
}

void CL_CALLBACK Capture::Shot::onEnd(cl_event, cl_int status, void* data) {
  const std::unique_ptr<std::shared_ptr<Shot>> held(static_cast<std::shared_ptr<Shot>*>(data));
  Shot& shot = **held;
  if (status == CL_COMPLETE && shot.complete) shot.write();
  if (status != CL_COMPLETE)
    shot.folder->fail("frame " + std::to_string(shot.number) + " failed: " + clErrorName(status));
  shot.frame = {};
  shot.outputs.clear();
  const std::lock_guard<std::mutex> lock(shot.mutex);
  shot.written = true;
  shot.changed.notify_all();
}

/// The runtime writes into the shot until its last read has ended.
void Capture::Shot::writeAtEnd(const std::shared_ptr<Shot>& shot) {
  if (shot->last() == nullptr) return;
  auto held = std::make_unique<std::shared_ptr<Shot>>(shot);
  shot->last.setCallback(CL_COMPLETE, onEnd, held.get());
  static_cast<void>(held.release());  // the callback's
}

CapturedFacts factsOf(const Configuration& configuration) {
  CapturedFacts facts;
  facts.version = QUELL_VERSION;
  facts.method = configuration.settings.method();
  std::istringstream identity(configuration.device.identity);
  for (std::string line; std::getline(identity, line);) facts.identity.push_back(line);
  facts.lanes = configuration.device.lanes;
  facts.options = configuration.options;
  return facts;
}

std::string captureDirectory(const Options& options) {
  if (options.captureDirectory) return *options.captureDirectory;
  const char* directory = std::getenv("QUELL_CAPTURE");
  return directory != nullptr ? directory : "";
}

Capture::Capture(const std::string& directory, const Configuration& configuration)
    : m_folder(std::make_shared<Folder>()),
      m_skip(configuration.options.captureSkip),
      m_left(configuration.options.captureFrames) {
  m_folder->state.directory = directory;
  try {
    open(directory, configuration);
  } catch (const std::exception& exception) {
    fail(exception.what());
  }
}

void Capture::open(const std::string& directory, const Configuration& configuration) {
  const std::string folder = makeFolder(directory);
  if (folder.empty()) return fail(directory + " has " + std::to_string(kMostFolders) + " captures already");
  m_folder->state.directory = folder;
  const std::string text = factsText(factsOf(configuration));
  const std::string path = (fs::path(folder) / kFactsFile).string();
  const std::string problem = writeWholeFile(path, {{text.data(), text.size()}});
  if (!problem.empty()) fail(path + " could not be written: " + problem);
}

Capture::~Capture() {
  for (const auto& shot : m_shots) {
    std::unique_lock<std::mutex> lock(shot->mutex);
    cl_int status = CL_QUEUED;
    clGetEventInfo(shot->last(), CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof(status), &status, nullptr);
    // Callbacks come a little after the end of what they are of.
    if (status <= CL_COMPLETE) shot->changed.wait_for(lock, kMostWait, [&] { return shot->written; });
  }
}

void Capture::fail(const std::string& problem) {
  m_folder->fail(problem);
  m_left = 0;
}

bool Capture::takesNext() {
  if (m_left == 0 || !state().problem.empty()) return false;
  if (m_skip > 0) return --m_skip, false;
  --m_left;
  return true;
}

CaptureState Capture::state() const {
  const std::lock_guard<std::mutex> lock(m_folder->mutex);
  return m_folder->state;
}

void Capture::read(const cl::CommandQueue& queue, cl_mem handle, const CapturedMemory& memory,
                   std::size_t begin, Bytes& bytes) {
  cl::Event event;
  if (memory.isImage)
    queue.enqueueReadImage(
        cl::Image2D(handle, true), CL_FALSE, {0, 0, 0},
        {static_cast<std::size_t>(memory.width), static_cast<std::size_t>(memory.height), 1}, 0, 0,
        bytes.data(), &m_waitFor, &event);
  else
    queue.enqueueReadBuffer(cl::Buffer(handle, true), CL_FALSE, begin, bytes.size(), bytes.data(), &m_waitFor,
                            &event);
  m_waitFor = {event};
  m_shot->last = event;
  m_events.emplace_back(0, event);
}

void Capture::readInputs(const cl::CommandQueue& queue, const Frame& frame, const Output& output,
                         const Facts& facts, const Pipeline& pipeline, std::vector<cl::Event>& waitFor) {
  m_events.clear();
  m_waitFor = waitFor;
  try {
    withClErrors("capture", [&] { begin(queue, frame, output, facts, pipeline); });
  } catch (const std::exception& exception) {
    fail(exception.what());
    dropFrame();
  }
  waitFor = m_waitFor;
}

void Capture::begin(const cl::CommandQueue& queue, const Frame& frame, const Output& output,
                    const Facts& facts, const Pipeline& pipeline) {
  m_shot = std::make_shared<Shot>();
  m_shot->folder = m_folder;
  m_shot->number = m_number++;
  CapturedFrame& captured = m_shot->frame;
  captured.frameIndex = facts.frameIndex;
  captured.frame = frame;
  const Frame& prepared = pipeline.configuration().frame;
  captured.frame.size = prepared.size;
  captured.frame.renderSize = hasRenderSize(prepared) ? frame.size : Size{};
  captured.frame.camera.worldToClipPrev = facts.worldToClipPrev;
  for (const SettingDescription& setting : facts.settings.descriptions())
    captured.settings.emplace_back(setting.name, facts.settings.text(setting.name));
  m_handles = captureViews(frame, output, captured);
  for (std::size_t i = 0; i < m_handles.size(); ++i) {
    CapturedMemory& memory = captured.memories[i];
    if (!readsFrom(captured, static_cast<int>(i))) continue;
    memory.content.resize(memory.size);
    read(queue, m_handles[i], memory, memory.base, memory.content);
  }
  if (m_shot->number == 0 && facts.frameIndex > 0) readHistories(queue, pipeline);
}

void Capture::readHistories(const cl::CommandQueue& queue, const Pipeline& pipeline) {
  std::vector<CapturedHistory>& captured = m_shot->frame.histories;
  const std::vector<BufferSet::History> histories = pipeline.buffers().histories();
  for (const BufferSet::History& history : histories)
    for (int copy = 0; copy < 2; ++copy) captured.push_back({history.name, copy, Bytes(history.bytes)});
  for (std::size_t i = 0; i < captured.size(); ++i)
    read(queue, histories[i / 2].copies[i % 2](), {}, 0, captured[i].content);
}

cl::Event Capture::readOutputs(const cl::CommandQueue& queue, const cl::Event& last) {
  if (!m_shot) return last;
  m_waitFor = {last};
  try {
    withClErrors("capture", [&] { end(queue); });
  } catch (const std::exception& exception) {
    fail(exception.what());
    dropFrame();
  }
  return m_waitFor.front();
}

void Capture::end(const cl::CommandQueue& queue) {
  Shot& shot = *m_shot;
  for (const CapturedView& view : shot.frame.views)
    shot.outputs.emplace_back(isOutput(view) ? rangeOf(view, shot.frame).size : 0);
  for (std::size_t i = 0; i < shot.outputs.size(); ++i) {
    const CapturedView& view = shot.frame.views[i];
    const auto memory = static_cast<std::size_t>(view.memory);
    if (isOutput(view))
      read(queue, m_handles[memory], shot.frame.memories[memory], rangeOf(view, shot.frame).begin,
           shot.outputs[i]);
  }
  queue.flush();
  shot.complete = true;
  Shot::writeAtEnd(m_shot);
  m_shots.push_back(std::move(m_shot));
}

void Capture::dropFrame() {
  try {
    if (m_shot) Shot::writeAtEnd(m_shot);
  } catch (const std::exception&) {
    static_cast<void>(new std::shared_ptr<Shot>(m_shot));  // the runtime may still write into it
  }
  m_shot.reset();
}

}  // namespace quell
