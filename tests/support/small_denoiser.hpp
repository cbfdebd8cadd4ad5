// A denoiser with small images on a device of its own, for tests of the public API.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/analytic/sequence.hpp"
#include "host/core/opencl.hpp"
#include "tests/support/image_layout.hpp"
#include "tests/support/temporary_directory.hpp"

namespace quell::tests {

/// A context and a queue on the device that QUELL_TEST_DEVICE names (index or part of a name), by default on
/// the one that quell::chooseDevice() prefers.
struct OpenDevice {
  explicit OpenDevice(cl_command_queue_properties properties = 0) : queue(context, device, properties) {}

  static cl::Device choose() {
    const char* spec = std::getenv("QUELL_TEST_DEVICE");
    return cl::Device(chooseDevice(spec != nullptr ? spec : "").device, true);
  }

  cl::Device device = choose();
  cl::Context context{device};
  cl::CommandQueue queue;
};

inline ImageLayout absent() { return packed(0); }

/// Size and layouts of the images of a frame; by default the smallest set that denoises well.
struct ImageSetup {
  ImageSetup() { radiance = normalWorld = positionWorld = albedo = emission = linear = display = packed(3); }

  Size size{37, 21};
#define QUELL_LAYOUT(name, ...) ImageLayout name = absent();
  QUELL_FRAME_IMAGES(QUELL_LAYOUT)
  QUELL_OUTPUT_IMAGES(QUELL_LAYOUT)
#undef QUELL_LAYOUT
  bool roundToHalf = false;  ///< round all inputs to half before they are stored, whatever they are stored as
};

/// Both outputs of a frame; an absent one is empty.
struct Picture {
  io::Image linear;
  io::Image display;
};
inline bool operator==(const Picture& a, const Picture& b) {
  return a.linear.pixels == b.linear.pixels && a.display.pixels == b.display.pixels;
}

/// Clip.w over the length of its row: depth along the view axis.
inline io::Image viewDepthOf(const io::FrameData& data) {
  const Matrix4& m = data.camera.worldToClip;
  const double unit = std::sqrt(m[12] * m[12] + m[13] * m[13] + m[14] * m[14]);
  io::Image depth(data.positionWorld.width, data.positionWorld.height, 1);
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      double w = m[15];
      for (int axis = 0; axis < 3; ++axis) w += m[12 + std::size_t(axis)] * data.positionWorld.at(x, y, axis);
      depth.at(x, y, 0) = static_cast<float>(w / unit);
    }
  return depth;
}

/// The built-in sequence at this size.
inline std::unique_ptr<io::FrameSequence> smallSequence(Size size) {
  io::AnalyticOptions options;
  options.width = size.width;
  options.height = size.height;
  return io::makeAnalyticSequence(options);
}

/// Device buffers of one frame and its outputs.
class FrameBuffers {
 public:
  FrameBuffers(const OpenDevice& device, const ImageSetup& setup)
      : m_queue(device.queue), m_sequence(smallSequence(setup.size)), m_roundToHalf(setup.roundToHalf) {
    frame.size = setup.size;
    forEachInput(setup, frame, [&](const ImageFacts&, const ImageLayout& layout, ImageView& view) {
      view = allocate(device, layout);
    });
    output.linear = allocate(device, setup.linear);
    output.display = allocate(device, setup.display);
    upload(0);
  }

  /// Fills the inputs with frame `number` of the built-in sequence and the outputs with a pattern; blocks.
  void upload(int number) {
    io::FrameData data = m_sequence->read(number);
    frame.camera = data.camera;
    data.viewDepth = viewDepthOf(data);
    data.glossColor = io::Image(frame.size.width, frame.size.height, 3, 0.25f);
    // What else the sequence has not is 0: nothing moves, and all is one object.
    forEachInput(data, frame, [&](const ImageFacts& facts, const io::Image& image, const ImageView& view) {
      writeInput(view,
                 image.empty() ? io::Image(frame.size.width, frame.size.height, facts.mostChannels) : image);
    });
    const io::Image nothing(frame.size.width, frame.size.height, 4, -1.0f);
    write(output.linear, nothing);
    write(output.display, nothing);
  }

  Picture download() const { return {read(output.linear), read(output.display)}; }

  std::vector<unsigned char> bytes(const ImageView& view) const {
    std::vector<unsigned char> result(view.requiredBytes(frame.size));
    m_queue.enqueueReadBuffer(cl::Buffer(view.memory, true), CL_TRUE, 0, result.size(), result.data());
    return result;
  }

  Frame frame;
  Output output;

 private:
  ImageView allocate(const OpenDevice& device, const ImageLayout& layout) {
    ImageView view = makeView(layout, frame.size);
    if (!view.present()) return view;
    m_buffers.emplace_back(device.context, CL_MEM_READ_WRITE, view.requiredBytes(frame.size));
    view.memory = m_buffers.back()();
    return view;
  }

  void writeInput(const ImageView& view, const io::Image& image) {
    write(view, m_roundToHalf
                    ? asStored(image, packedImage(nullptr, image.channels, ComponentFormat::Float16))
                    : image);
  }

  void write(const ImageView& view, const io::Image& image) {
    if (!view.present()) return;
    const auto bytes = encodeImage(image, view, frame.size);
    m_queue.enqueueWriteBuffer(cl::Buffer(view.memory, true), CL_TRUE, 0, bytes.size(), bytes.data());
  }

  io::Image read(const ImageView& view) const {
    return view.present() ? decodeImage(bytes(view), view, frame.size) : io::Image();
  }

  cl::CommandQueue m_queue;
  std::unique_ptr<io::FrameSequence> m_sequence;
  bool m_roundToHalf;
  std::vector<cl::Buffer> m_buffers;
};

/// Options that leave the user's cache directory alone. Tests of one process share a directory, since many denoisers of
/// the usual kind start faster from binaries.
inline Options testOptions(TimerMode timers = TimerMode::Off) {
  static const TemporaryDirectory directory;
  Options options;
  options.timers = timers;
  options.cacheDirectory = directory.path();
  return options;
}

/// The same without a directory, for kernels that one test alone needs: for a binary PoCL compiles them once more.
inline Options uncachedOptions() {
  Options options = testOptions();
  options.cacheDirectory = "";
  return options;
}

/// A prepared denoiser with all it needs.
class SmallDenoiser {
 public:
  SmallDenoiser() : SmallDenoiser(ImageSetup(), testOptions()) {}
  explicit SmallDenoiser(const ImageSetup& setup, const Options& options = uncachedOptions(),
                         cl_command_queue_properties properties = 0, const Settings& settings = Settings())
      : device(properties),
        buffers(device, setup),
        denoiser(device.context, device.device, device.queue, settings, options) {
    denoiser.prepare(buffers.frame, buffers.output);
  }

  /// Enqueues a frame whose images have been uploaded.
  Event enqueue(const std::vector<cl_event>& waitList = {}) {
    return denoiser.denoise(buffers.frame, buffers.output, waitList);
  }

  /// Denoises the frames up to `last` of the built-in sequence, one by one; the picture of the last.
  Picture run(int first, int last) {
    for (int number = first; number <= last; ++number) {
      buffers.upload(number);
      enqueue().wait();
    }
    return buffers.download();
  }
  Picture run(int number) { return run(number, number); }

  OpenDevice device;
  FrameBuffers buffers;
  Denoiser denoiser;
};

/// A user event that holds back what waits for it. Set to complete at the latest when it goes, so that a
/// failing test does not hang.
class Gate {
 public:
  explicit Gate(const cl::Context& context) : m_event(context) {}
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;
  ~Gate() {
    if (!m_set) clSetUserEventStatus(m_event(), CL_COMPLETE);
  }
  cl_event event() const { return m_event(); }
  void open() { set(CL_COMPLETE); }
  void fail() { set(-1); }

 private:
  void set(cl_int status) {
    m_set = true;
    m_event.setStatus(status);
  }

  cl::UserEvent m_event;
  bool m_set = false;
};

/// What an Error must say: code, stage and buffer, and parts of what was expected and of what came.
struct Refusal {
  ErrorCode code = ErrorCode::InvalidArgument;
  std::string stage;
  std::string buffer;
  std::string expected;
  std::string got;
};

/// Fails the test unless the call throws an Error that says so.
template <class Call>
void checkRefused(const Refusal& refusal, Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    INFO(error.what());
    CHECK(toString(error.code()) == std::string(toString(refusal.code)));
    CHECK(error.stage() == refusal.stage);
    CHECK(error.buffer() == refusal.buffer);
    CHECK_THAT(error.expected(), Catch::Contains(refusal.expected));
    CHECK_THAT(error.got(), Catch::Contains(refusal.got));
    return;
  }
  FAIL_CHECK("not refused; expected " << refusal.buffer << ": " << refusal.expected);
}

/// Fails the test unless the denoiser gives, after a reset, what an untouched one gives.
inline void checkStillWorks(SmallDenoiser& small) {
  static const Picture expected = SmallDenoiser().run(0, 1);
  small.denoiser.resetHistory();
  CHECK(small.run(0, 1) == expected);
}

/// Execution status of the event's command: CL_COMPLETE, CL_QUEUED... or negative.
inline cl_int statusOf(const Event& event) {
  cl_int status = CL_QUEUED;
  clGetEventInfo(event.get(), CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof(status), &status, nullptr);
  return status;
}

}  // namespace quell::tests
