// Changes between frames: settings, queues, sizes; memory that is shared with the host.
#include <catch2/catch.hpp>
#include <chrono>
#include <set>
#include <thread>

#include "tests/support/small_denoiser.hpp"

// Of OpenCL 2.0; Quell's headers are those of 1.2.
extern "C" void* clSVMAlloc(cl_context context, cl_bitfield flags, size_t bytes, cl_uint alignment);
extern "C" void clSVMFree(cl_context context, void* pointer);

namespace quell::tests {
namespace {

Settings with(const std::string& name, double value) {
  Settings settings;
  settings.set(name, value);
  return settings;
}

}  // namespace

TEST_CASE("settings that need no other kernel change between frames", "[core]") {
  const Settings settings = with("luminanceSigma", 1.0);
  SmallDenoiser before, small, other({}, testOptions(), 0, settings);
  const Picture expected = other.run(0, 3);
  before.run(0, 2);
  small.run(0, 2);
  small.denoiser.setSettings(settings);
  CHECK(small.denoiser.settings().get("luminanceSigma") == 1.0);
  const Picture changed = small.run(3);
  CHECK_FALSE(changed == before.run(3));
  // What the filter gives stays out of the history of light: it is as if the setting had always been so.
  CHECK(changed.linear.pixels == expected.linear.pixels);
}

TEST_CASE("settings that need other kernels or buffers are named", "[core]") {
  SmallDenoiser small;
  const Picture expected = SmallDenoiser().run(0, 1);
  Settings settings = with("iterations", 3);
  settings.set("exposure", 1.0);
  CHECK(small.denoiser.settingsToPrepare(settings) == std::vector<std::string>{"iterations"});
  settings.set("toneMap", "aces");
  checkRefused({ErrorCode::NotPrepared, "setSettings", "iterations, toneMap", "need no prepare()", ""},
               [&] { small.denoiser.setSettings(settings); });
  CHECK(small.run(0, 1) == expected);
  checkRefused({ErrorCode::InvalidArgument, "setSettings", "method", "quell", "svgf"},
               [&] { small.denoiser.setSettings(Settings("svgf")); });
}

TEST_CASE("what a setting needs follows from its stages", "[core]") {
  const auto live = [](const std::string& method) {
    SmallDenoiser small({}, testOptions(), 0, Settings(method));
    std::set<std::string> names;
    for (const SettingDescription& setting : methodSettings(method)) {
      if (setting.kind != SettingKind::Real) continue;
      Settings settings(method);
      settings.set(setting.name, 0.5 * (std::max(setting.minimum, 0.1) + std::min(setting.maximum, 1.0)));
      if (small.denoiser.settingsToPrepare(settings).empty()) names.insert(setting.name);
    }
    return names;
  };
  const std::set<std::string> quell = live("quell");
  for (const char* name : {"momentsLeastWeight", "changeThreshold", "luminanceSigma", "depthSigma",
                           "exposure", "taaNewestWeight", "positionLimit"}) {
    INFO(name);
    CHECK(quell.count(name) == 1);
  }
}

TEST_CASE("frames may come on several queues of the context", "[core]") {
  SmallDenoiser small;
  const cl::CommandQueue other(small.device.context, small.device.device,
                               CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
  for (int i = 0; i < 4; ++i) small.enqueue().wait();
  const Picture still = small.buffers.download();
  small.denoiser.resetHistory();
  Gate gate(small.device.context);
  Event last;
  for (int i = 0; i < 4; ++i)  // all in flight, the first held back
    last = small.denoiser.denoise(small.buffers.frame, small.buffers.output,
                                  i == 0 ? std::vector<cl_event>{gate.event()} : std::vector<cl_event>{},
                                  i % 2 == 0 ? nullptr : other());
  CHECK(statusOf(last) > CL_RUNNING);
  gate.open();
  last.wait();
  CHECK(small.buffers.download() == still);
  const OpenDevice foreign;
  checkRefused({ErrorCode::WrongContext, "denoise", "queue", "the given context", "another context's"}, [&] {
    small.denoiser.denoise(small.buffers.frame, small.buffers.output, {}, foreign.queue());
  });
}

TEST_CASE("shared virtual memory comes as buffers over its pointers", "[core]") {
  SmallDenoiser small;
  const Picture expected = small.run(0, 1);
  small.denoiser.resetHistory();
  const std::size_t bytes = small.buffers.frame.radiance.requiredBytes(small.buffers.frame.size);
  void* pointer = clSVMAlloc(small.device.context(), CL_MEM_READ_WRITE, bytes, 0);
  if (pointer == nullptr) return;  // a device without
  {
    const cl::Buffer shared(small.device.context, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, bytes, pointer);
    small.buffers.frame.radiance.memory = shared();
    CHECK(small.run(0, 1) == expected);
    cl::Event unmapped;
    small.device.queue.enqueueMapBuffer(shared, CL_TRUE, CL_MAP_READ, 0, bytes);
    small.device.queue.enqueueUnmapMemObject(shared, pointer, nullptr, &unmapped);
    unmapped.wait();
  }
  clSVMFree(small.device.context(), pointer);
}

// 10,000 frames are run by hand (QUELL_TEST_FRAMES).
TEST_CASE("frames with resizes and cuts gather neither memory nor handles", "[core]") {
  const char* wanted = std::getenv("QUELL_TEST_FRAMES");
  const int frames = wanted != nullptr ? std::atoi(wanted) : 60;
  constexpr int kResizeEvery = 20, kCutEvery = 7;
  SmallDenoiser small;
  const FrameBuffers larger(small.device, [] {
    ImageSetup setup;
    setup.size = {64, 64};
    return setup;
  }());
  const auto references = [&] { return small.device.context.getInfo<CL_CONTEXT_REFERENCE_COUNT>(); };
  const auto run = [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const FrameBuffers& buffers = i / kResizeEvery % 2 == 0 ? small.buffers : larger;
      PrepareOptions keep;
      keep.keepHistory = i % (4 * kResizeEvery) != 0;
      if (i % kResizeEvery == 0) small.denoiser.prepare(buffers.frame, buffers.output, keep);
      if (i % kCutEvery == 0) small.denoiser.resetHistory();
      const Event done = small.denoiser.denoise(buffers.frame, buffers.output);
      if (i % 3 == 2) done.wait();  // three in flight
    }
    small.device.queue.finish();
  };
  run(0, 2 * kResizeEvery);
  const cl_uint before = references();
  run(2 * kResizeEvery, std::max(frames, 2) / (2 * kResizeEvery) * 2 * kResizeEvery + 2 * kResizeEvery);
  for (int i = 0; i < 1000 && references() > before; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  CHECK(references() <= before);
}

}  // namespace quell::tests
