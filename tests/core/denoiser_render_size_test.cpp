// Dynamic resolution: frames that render a part of the prepared size.
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <quell/replay.hpp>
#include <thread>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr Size kWhole{45, 30}, kPart{29, 18};

ImageSetup setupOf(Size size) {
  ImageSetup setup;
  setup.size = size;
  return setup;
}

/// One frame of the built-in sequence at a size of its own, for a denoiser that is prepared for kWhole.
struct Rendered {
  Rendered(const OpenDevice& device, Size size, int number) : buffers(device, setupOf(size)) {
    buffers.upload(number);
    frame = buffers.frame;
    output = buffers.output;
    for (const auto& image : kInputs<Frame>) fixPitch(frame.*image.member, size);
    for (const auto& image : kOutputs<Output>) fixPitch(output.*image.member, size);
    frame.size = kWhole;
    frame.renderSize = size;
  }

  static void fixPitch(ImageView& view, Size size) { view.rowPitchBytes = view.rowPitch(size.width); }

  FrameBuffers buffers;
  Frame frame;
  Output output;
};

/// Denoisers on one device, so that they share their programs.
struct Denoisers {
  explicit Denoisers(cl_command_queue_properties properties = 0, const Options& options = testOptions())
      : device(properties), part(make(options)), whole(device, setupOf(kWhole)) {
    Frame frame = whole.frame;
    frame.renderSize = kPart;
    part.prepare(frame, whole.output);
  }

  Denoiser make(const Options& options = testOptions()) {
    return Denoiser(device.context, device.device, device.queue, Settings(), options);
  }

  Picture runPart(int number, Size size) {
    const Rendered rendered(device, size, number);
    part.denoise(rendered.frame, rendered.output).wait();
    return rendered.buffers.download();
  }

  OpenDevice device;
  Denoiser part;  // its frames have render sizes
  FrameBuffers whole;
};

Picture run(Denoiser& denoiser, FrameBuffers& buffers, int first, int last) {
  for (int number = first; number <= last; ++number) {
    buffers.upload(number);
    denoiser.denoise(buffers.frame, buffers.output).wait();
  }
  return buffers.download();
}

double rmse(const io::Image& a, const io::Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::pow(double(a.pixels[i]) - b.pixels[i], 2);
  return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

}  // namespace

TEST_CASE("a render size gives what a denoiser of that size gives", "[core]") {
  Denoisers d;
  FrameBuffers small(d.device, setupOf(kPart));
  Denoiser fresh = d.make();
  fresh.prepare(small.frame, small.output);
  const Picture expected = run(fresh, small, 0, 1);
  d.runPart(0, kPart);
  CHECK(d.runPart(1, kPart) == expected);
  // Buffers that frames of another size have left are as good as new ones.
  run(d.part, d.whole, 0, 1);
  d.part.resetHistory();
  d.runPart(0, kPart);
  CHECK(d.runPart(1, kPart) == expected);
  CHECK(d.part.readBuffer("guides").width == kPart.width);
}

TEST_CASE("a render size leaves the rest of larger images alone", "[core]") {
  Denoisers d;
  Frame frame = d.whole.frame;
  frame.renderSize = kPart;
  d.part.denoise(frame, d.whole.output).wait();
  const Picture picture = d.whole.download();
  const float untouched = -1.0f;  // as FrameBuffers fills outputs
  for (int y = 0; y < kWhole.height; ++y)
    for (int x = 0; x < kWhole.width; ++x) {
      const bool rendered = x < kPart.width && y < kPart.height;
      CHECK((picture.linear.at(x, y, 2) != untouched) == rendered);
      CHECK((picture.display.at(x, y, 0) != untouched) == rendered);
    }
}

TEST_CASE("a change of the render size keeps the history as prepare() keeps it", "[core]") {
  Denoisers d(CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
  FrameBuffers small(d.device, setupOf(kPart));
  Denoiser prepared = d.make();
  PrepareOptions keep;
  keep.keepHistory = true;
  prepared.prepare(d.whole.frame, d.whole.output);
  std::vector<Picture> expected;
  for (int number = 0; number < 6; ++number) {
    FrameBuffers& buffers = number / 2 == 1 ? small : d.whole;
    if (number == 2 || number == 4) prepared.prepare(buffers.frame, buffers.output, keep);
    expected.push_back(run(prepared, buffers, number, number));
  }
  const std::size_t bytes = d.part.memoryUse().totalBytes;
  std::vector<std::unique_ptr<Rendered>> frames;
  for (int number = 0; number < 6; ++number)
    frames.push_back(std::make_unique<Rendered>(d.device, number / 2 == 1 ? kPart : kWhole, number));
  const auto runAll = [&] {
    Gate gate(d.device.context);
    Event last;
    for (std::size_t i = 0; i < frames.size(); ++i)  // all in flight, the first held back
      last = d.part.denoise(frames[i]->frame, frames[i]->output,
                            i == 0 ? std::vector<cl_event>{gate.event()} : std::vector<cl_event>{});
    CHECK(statusOf(last) > CL_RUNNING);
    gate.open();
    last.wait();
  };
  runAll();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    INFO("frame " << i);
    CHECK(frames[i]->buffers.download() == expected[i]);
  }
  CHECK(d.part.memoryUse().totalBytes == bytes);
  // Buffers and events hold the context.
  const auto references = [&] { return d.device.context.getInfo<CL_CONTEXT_REFERENCE_COUNT>(); };
  const cl_uint before = references();
  d.part.resetHistory();
  runAll();
  for (int i = 0; i < 1000 && references() > before; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  CHECK(references() <= before);
}

TEST_CASE("after a change of the render size pictures are soon those of a denoiser of that size", "[core]") {
  Denoisers d;
  FrameBuffers small(d.device, setupOf(kPart));
  Denoiser fresh = d.make();
  fresh.prepare(small.frame, small.output);
  Denoiser reset = d.make();
  reset.prepare(small.frame, small.output);
  constexpr int kChange = 8, kLast = 15;
  run(d.part, d.whole, 0, kChange - 1);
  run(fresh, small, 0, kChange - 1);
  for (int number = kChange; number <= kLast; ++number) {
    const Picture expected = run(fresh, small, number, number);
    const double kept = rmse(d.runPart(number, kPart).display, expected.display);
    const double lost = rmse(run(reset, small, number, number).display, expected.display);
    INFO("frame " << number << ": " << kept << ", with a reset " << lost);
    if (number < kChange + 5) CHECK(kept < 0.9 * lost);
    if (number == kLast) CHECK(kept < 0.03);
  }
}

TEST_CASE("render sizes that do not fit are refused", "[core]") {
  Denoisers d;
  Frame frame = d.whole.frame;
  const auto refused = [&](Size size, ErrorCode code, const std::string& buffer, const std::string& expected,
                           const std::string& got) {
    frame.renderSize = size;
    checkRefused({code, "denoise", buffer, expected, got}, [&] { d.part.denoise(frame, d.whole.output); });
  };
  refused({46, 30}, ErrorCode::InvalidArgument, "renderSize", "1x1 to the frame's size of 45x30", "46x30");
  refused({45, 0}, ErrorCode::InvalidArgument, "renderSize", "0x0 for all of it", "45x0");
  refused({-1, -1}, ErrorCode::InvalidArgument, "renderSize", "1x1", "-1x-1");
  frame.albedo.rowPitchBytes = 8;
  refused({20, 20}, ErrorCode::InvalidArgument, "albedo", "a row pitch of at least 240 bytes", "8");
  frame.albedo.rowPitchBytes = 0;
  frame.renderSize = {99, 1};
  checkRefused({ErrorCode::InvalidArgument, "prepare", "renderSize", "45x30", "99x1"},
               [&] { d.part.memoryNeeded(frame, d.whole.output); });
  Denoiser whole = d.make();
  whole.prepare(d.whole.frame, d.whole.output);
  frame.renderSize = kPart;
  checkRefused({ErrorCode::NotPrepared, "denoise", "renderSize", "a prepare() with any", "29x18"},
               [&] { whole.denoise(frame, d.whole.output); });
  CHECK(d.part.kernelStates(frame, d.whole.output).back().stage == "resample_history");
}

TEST_CASE("frames of several render sizes are captured and run again", "[core]") {
  const TemporaryDirectory directory;
  Options options = testOptions();
  options.captureDirectory = directory.path();
  options.captureSkip = 1;
  {
    Denoisers d(0, options);
    for (int number = 0; number < 4; ++number) d.runPart(number, number % 2 == 0 ? kWhole : kPart);
  }
  const OpenDevice device;
  const std::vector<Replay> replays =
      replay(directory.path(), device.context(), device.device(), device.queue());
  REQUIRE(replays.size() == 1);
  CHECK(replays[0].frames.size() == 3);
  INFO(toText(replays[0]));
  CHECK(replays[0].equal());
}

}  // namespace quell::tests
