#include <algorithm>
#include <filesystem>
#include <iterator>
#include <quell/error.hpp>
#include <quell/replay.hpp>

#include "host/api/captured_frame.hpp"
#include "host/api/captured_lines.hpp"
#include "host/api/captured_views.hpp"
#include "host/api/denoiser_implementation.hpp"
#include "host/core/cl_error.hpp"
#include "host/core/image_schema.hpp"
#include "host/core/named_views.hpp"
#include "host/core/render_rectangle.hpp"

namespace quell {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& expected, const std::string& got) {
  throw Error(ErrorCode::FileError, {"replay", path, expected, got});
}

/// The memory objects of a captured frame, made anew, and the frame on top of them.
class RemadeFrame {
 public:
  RemadeFrame(const cl::Context& context, const cl::CommandQueue& queue, const CapturedFrame& captured,
              const std::string& path)
      : frame(captured.frame) {
    for (const CapturedMemory& memory : captured.memories) remake(context, queue, memory, path);
    for (const CapturedView& view : captured.views) {
      if (view.memory < 0 || static_cast<std::size_t>(view.memory) >= m_memories.size())
        refuse(path, "views of captured memory", "memory " + std::to_string(view.memory));
      ImageView* target = find(view.name);
      if (target == nullptr) refuse(path, "images that this version knows", view.name);
      const CapturedMemory& memory = captured.memories[static_cast<std::size_t>(view.memory)];
      *target = view.view;
      target->memory = m_memories[static_cast<std::size_t>(view.memory)]();
      if (!memory.isImage) target->offsetBytes -= static_cast<std::size_t>(memory.base);
    }
  }

  Frame frame;
  Output output;

 private:
  void remake(const cl::Context& context, const cl::CommandQueue& queue, const CapturedMemory& memory,
              const std::string& path) {
    const auto width = static_cast<std::size_t>(memory.width),
               height = static_cast<std::size_t>(memory.height);
    if (memory.isImage)
      m_memories.push_back(
          cl::Image2D(context, CL_MEM_READ_WRITE, cl::ImageFormat(memory.order, memory.type), width, height));
    else
      m_memories.push_back(cl::Buffer(context, CL_MEM_READ_WRITE, static_cast<std::size_t>(memory.size)));
    const cl_mem handle = m_memories.back()();
    if (memory.isImage) {
      const std::size_t bytes =
          width * height * cl::Image2D(handle, true).getImageInfo<CL_IMAGE_ELEMENT_SIZE>();
      if (bytes != memory.size)
        refuse(path, "an image of " + std::to_string(bytes) + " bytes", std::to_string(memory.size));
    }
    if (memory.content.empty()) return;
    if (memory.isImage)
      queue.enqueueWriteImage(cl::Image2D(handle, true), CL_TRUE, {0, 0, 0}, {width, height, 1}, 0, 0,
                              memory.content.data());
    else
      queue.enqueueWriteBuffer(cl::Buffer(handle, true), CL_TRUE, 0, memory.content.size(),
                               memory.content.data());
  }

  ImageView* find(const std::string& name) {
    for (const auto& image : kInputs<Frame>)
      if (name == image.name) return &(frame.*image.member);
    for (const auto& image : kOutputs<Output>)
      if (name == std::string("output.") + image.name) return &(output.*image.member);
    return nullptr;
  }

  std::vector<cl::Memory> m_memories;
};

Settings settingsOf(const CapturedFacts& facts, const CapturedFrame& frame) {
  Settings settings(facts.method);
  for (const auto& [name, value] : frame.settings) settings.set(name, value);
  return settings;
}

Bytes readOutput(const cl::CommandQueue& queue, const ImageView& view, Size size,
                 const CapturedMemory& memory) {
  const ByteRange range =
      memory.isImage ? ByteRange{0, static_cast<std::size_t>(memory.size)} : rangeOf(view, size);
  Bytes bytes(range.size);
  if (memory.isImage)
    queue.enqueueReadImage(
        cl::Image2D(view.memory, true), CL_TRUE, {0, 0, 0},
        {static_cast<std::size_t>(memory.width), static_cast<std::size_t>(memory.height), 1}, 0, 0,
        bytes.data());
  else
    queue.enqueueReadBuffer(cl::Buffer(view.memory, true), CL_TRUE, range.begin, bytes.size(), bytes.data());
  return bytes;
}

std::vector<std::string> foldersIn(const std::string& directory) {
  std::error_code ignored;
  if (fs::exists(fs::path(directory) / kFactsFile, ignored)) return {directory};
  std::vector<std::string> folders;
  for (const auto& entry : fs::directory_iterator(directory, ignored))
    if (fs::exists(entry.path() / kFactsFile, ignored)) folders.push_back(entry.path().string());
  std::sort(folders.begin(), folders.end());
  if (folders.empty())
    refuse(directory, std::string("a folder with ") + kFactsFile + ", or one of such folders",
           fs::is_directory(directory, ignored) ? "none in it" : "no folder");
  return folders;
}

std::vector<std::string> framesIn(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code ignored;
  for (int number = 0;; ++number) {
    const fs::path path = fs::path(folder) / frameFileName(number);
    if (!fs::is_regular_file(path, ignored)) break;
    files.push_back(path.string());
  }
  if (files.empty()) refuse(folder, "captured frames from " + frameFileName(0) + " on", "none");
  return files;
}

}  // namespace

/// Runs the frames of one folder.
class Replayer {
 public:
  Replayer(const std::string& folder, const cl::Context& context, const cl::Device& device,
           const cl::CommandQueue& queue, const std::optional<std::string>& cacheDirectory)
      : m_context(context),
        m_device(device),
        m_queue(queue),
        m_facts(readFacts((fs::path(folder) / kFactsFile).string())) {
    m_replay.directory = folder;
    m_replay.method = m_facts.method;
    m_facts.options.cacheDirectory = cacheDirectory;
    m_facts.options.captureDirectory = "";
  }

  Replay run() {
    for (const std::string& file : framesIn(m_replay.directory)) runFrame(file);
    compareFacts();
    return std::move(m_replay);
  }

 private:
  void runFrame(const std::string& path) {
    const CapturedFrame captured = readFrame(path);
    const RemadeFrame remade(m_context, m_queue, captured, path);
    const Settings settings = settingsOf(m_facts, captured);
    if (!m_denoiser) {
      m_denoiser = std::make_unique<Denoiser>(m_context(), m_device(), m_queue(), settings, m_facts.options);
      m_denoiser->prepare(remade.frame, remade.output);
    }
    Denoiser::Implementation& denoiser = *m_denoiser->m_implementation;
    denoiser.setSettings(settings);
    denoiser.continueFrom(captured.frameIndex);
    // Histories are captured as the frame finds them, resampled already.
    if (!captured.histories.empty()) denoiser.setRenderSize(renderedSize(captured.frame));
    for (const CapturedHistory& history : captured.histories) restore(denoiser, history, path);
    m_denoiser->denoise(remade.frame, remade.output).wait();
    ReplayedFrame frame{static_cast<int>(m_replay.frames.size()), {}};
    for (const CapturedOutput& output : captured.outputs)
      frame.outputs.push_back({output.name, output.hash, hashOf(output.name, captured, remade, path)});
    m_replay.frames.push_back(std::move(frame));
  }

  std::uint64_t hashOf(const std::string& name, const CapturedFrame& captured, const RemadeFrame& remade,
                       const std::string& path) const {
    for (const NamedView& named : namedViews(remade.frame, remade.output))
      for (const CapturedView& view : captured.views)
        if (view.name == name && named.name == name)
          return pixelHash(view, captured,
                           readOutput(m_queue, *named.view, renderedSize(captured.frame),
                                      captured.memories[static_cast<std::size_t>(view.memory)]));
    refuse(path, "a view of the output " + name, "none");
  }

  void restore(const Denoiser::Implementation& denoiser, const CapturedHistory& captured,
               const std::string& path) const {
    for (const BufferSet::History& history : denoiser.histories()) {
      if (history.name != captured.name || history.bytes != captured.content.size()) continue;
      m_queue.enqueueWriteBuffer(history.copies[captured.copy == 0 ? 0 : 1], CL_TRUE, 0, history.bytes,
                                 captured.content.data());
      return;
    }
    refuse(path, "histories that this version of the method has", captured.name);
  }

  void compare(const std::string& fact, const std::string& captured, const std::string& here) {
    if (captured != here) m_replay.differences.push_back({fact, captured, here});
  }

  void compareFacts() {
    const CapturedFacts here = factsOf(m_denoiser->m_implementation->configuration());
    compare("version of Quell", m_facts.version, here.version);
    for (std::size_t i = 0; i < std::size(kIdentityNames); ++i)
      compare(kIdentityNames[i], i < m_facts.identity.size() ? m_facts.identity[i] : "",
              i < here.identity.size() ? here.identity[i] : "");
    compare("pixels a work-item", std::to_string(m_facts.lanes), std::to_string(here.lanes));
  }

  const cl::Context& m_context;
  const cl::Device& m_device;
  const cl::CommandQueue& m_queue;
  CapturedFacts m_facts;
  Replay m_replay;
  std::unique_ptr<Denoiser> m_denoiser;
};

bool Replay::equal() const {
  return std::all_of(frames.begin(), frames.end(), [](const ReplayedFrame& frame) {
    return std::all_of(frame.outputs.begin(), frame.outputs.end(),
                       [](const ReplayedOutput& output) { return output.captured == output.here; });
  });
}

std::string toText(const Replay& replay) {
  std::string text =
      replay.directory + ": " + replay.method + ", " + std::to_string(replay.frames.size()) + " frames\n";
  for (const ReplayedFrame& frame : replay.frames) {
    text += "  frame " + std::to_string(frame.number);
    for (const ReplayedOutput& output : frame.outputs) {
      text += "   " + output.image + " " + hashText(output.captured);
      text += output.captured == output.here ? " equal" : ", here " + hashText(output.here);
    }
    text += "\n";
  }
  for (const FactDifference& difference : replay.differences)
    text +=
        "  " + difference.fact + ": captured on " + difference.captured + ", here " + difference.here + "\n";
  return text + (replay.equal() ? "  all outputs are equal, bit for bit\n" : "  outputs differ\n");
}

std::vector<Replay> replay(const std::string& directory, cl_context context, cl_device_id device,
                           cl_command_queue queue, const std::optional<std::string>& cacheDirectory) {
  return withClErrors("replay", [&] {
    const cl::Context onContext(context, true);
    const cl::Device onDevice(device, true);
    const cl::CommandQueue onQueue(queue, true);
    std::vector<Replay> replays;
    for (const std::string& folder : foldersIn(directory))
      replays.push_back(Replayer(folder, onContext, onDevice, onQueue, cacheDirectory).run());
    return replays;
  });
}

}  // namespace quell
