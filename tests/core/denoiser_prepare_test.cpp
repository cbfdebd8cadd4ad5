// Preparing with progress, on a thread of its own, cancelled, and again with the history kept.
#include <catch2/catch.hpp>
#include <chrono>
#include <optional>
#include <thread>

#include "host/core/buffer_reader.hpp"
#include "host/core/history_transfer.hpp"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

// Two minutes at most.
void waitUntilReady(Denoiser& denoiser) {
  for (int i = 0; i < 12000 && !denoiser.isReady(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  REQUIRE(denoiser.isReady());
}

double meanError(const io::Image& a, const io::Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
  return sum / static_cast<double>(a.pixels.size());
}

}  // namespace

TEST_CASE("prepareAsync() gives the same pictures, and none before it is ready", "[core]") {
  SmallDenoiser small;
  const Picture expected = small.run(0, 2);
  std::vector<PrepareProgress> steps;
  std::thread::id thread;
  PrepareOptions options;
  options.progress = [&](const PrepareProgress& progress) {
    steps.push_back(progress);
    thread = std::this_thread::get_id();
  };
  Gate gate(small.device.context);
  small.enqueue({gate.event()});  // preparing waits for it
  small.denoiser.prepareAsync(small.buffers.frame, small.buffers.output, options);
  CHECK_FALSE(small.denoiser.isReady());
  checkRefused({ErrorCode::NotPrepared, "denoise", "", "a call of prepare()", "prepareAsync() is at"},
               [&] { small.enqueue(); });
  CHECK(small.denoiser.memoryUse().totalBytes == 0);
  gate.open();
  waitUntilReady(small.denoiser);
  CHECK(thread != std::this_thread::get_id());
  REQUIRE_FALSE(steps.empty());
  CHECK(steps.front().done == 1);
  CHECK(steps.back().done == steps.back().total);
  CHECK(int(steps.size()) == steps.back().total);
  CHECK(small.run(0, 2) == expected);
}

TEST_CASE("a preparation can be cancelled, here and on its thread", "[core]") {
  SmallDenoiser small;
  PrepareOptions options;
  options.progress = [&](const PrepareProgress& progress) {
    if (progress.done == 2) small.denoiser.cancelPrepare();
  };
  const Refusal cancelled{ErrorCode::NotPrepared, "prepare", "", "time to finish", "after 2 of"};
  checkRefused(cancelled,
               [&] { small.denoiser.prepare(small.buffers.frame, small.buffers.output, options); });
  CHECK_FALSE(small.denoiser.isReady());
  small.denoiser.prepareAsync(small.buffers.frame, small.buffers.output, options);
  checkRefused(cancelled, [&] { waitUntilReady(small.denoiser); });
  checkRefused({ErrorCode::NotPrepared, "denoise", "", "a call of prepare()", "none that succeeded"},
               [&] { small.enqueue(); });
  small.denoiser.prepare(small.buffers.frame, small.buffers.output);
  checkStillWorks(small);
}

TEST_CASE("a denoiser may go, or prepare anew, while it is being prepared", "[core]") {
  const OpenDevice device;
  const FrameBuffers buffers(device, {});
  std::optional<Denoiser> doomed(std::in_place, device.context, device.device, device.queue, Settings(),
                                 testOptions());
  doomed->prepareAsync(buffers.frame, buffers.output);
  doomed->prepareAsync(buffers.frame, buffers.output);
  waitUntilReady(*doomed);
  // A preparation that waits for a frame that nothing lets begin.
  Gate gate(device.context);
  doomed->denoise(buffers.frame, buffers.output, {gate.event()});
  doomed->prepareAsync(buffers.frame, buffers.output);
  doomed.reset();
}

TEST_CASE("it is known which kernels are there", "[core]") {
  SmallDenoiser small;
  const auto statesOf = [&](const Denoiser& denoiser) {
    std::vector<KernelState> states;
    for (const StageKernel& kernel : denoiser.kernelStates(small.buffers.frame, small.buffers.output))
      states.push_back(kernel.state);
    return states;
  };
  const std::size_t stages = statesOf(small.denoiser).size();
  CHECK(stages > 8);
  CHECK(statesOf(small.denoiser) == std::vector<KernelState>(stages, KernelState::Built));
  const auto fresh = [&](const Options& options) {
    return Denoiser(small.device.context, small.device.device, small.device.queue, Settings(), options);
  };
  CHECK(statesOf(fresh(testOptions())) == std::vector<KernelState>(stages, KernelState::Cached));
}

TEST_CASE("programs are shared while somebody holds them", "[core]") {
  const SmallDenoiser small;
  const ProgramCacheCounters before = ProgramCache::counters();
  Denoiser other(small.device.context, small.device.device, small.device.queue, Settings(), testOptions());
  other.prepare(small.buffers.frame, small.buffers.output);
  CHECK(ProgramCache::counters().built == before.built);
  CHECK(ProgramCache::counters().fromMemory == before.fromMemory);
  CHECK(ProgramCache::counters().fromDisk == before.fromDisk);
}

TEST_CASE("arguments that prepare() refuses change nothing", "[core]") {
  SmallDenoiser untouched;
  const Picture expected = untouched.run(0, 4);
  SmallDenoiser small;
  small.run(0, 3);
  PrepareOptions others;
  others.settings = Settings();
  others.settings->set("taa", "off");
  Frame minimised = small.buffers.frame;
  minimised.size = {0, 0};
  checkRefused({ErrorCode::InvalidArgument, "prepare", "size", "1x1", "0x0"},
               [&] { small.denoiser.prepare(minimised, small.buffers.output, others); });
  checkRefused({ErrorCode::InvalidArgument, "prepare", "size", "1x1", "0x0"},
               [&] { small.denoiser.prepareAsync(minimised, small.buffers.output, others); });
  const cl::Buffer tooSmall(small.device.context, CL_MEM_READ_WRITE, 100);
  Frame broken = small.buffers.frame;
  broken.normalWorld.memory = tooSmall();
  checkRefused(
      {ErrorCode::InvalidArgument, "prepare", "normalWorld", "at least 9324 bytes for 37x21", "100 bytes"},
      [&] { small.denoiser.prepare(broken, small.buffers.output); });
  CHECK(small.denoiser.settings().isOn("taa"));
  CHECK(small.run(4) == expected);
}

TEST_CASE("preparing again may keep the history", "[core]") {
  SmallDenoiser untouched;
  const Picture expected = untouched.run(0, 4);
  SmallDenoiser small;
  small.run(0, 3);
  PrepareOptions keep;
  keep.keepHistory = true;
  small.denoiser.prepare(small.buffers.frame, small.buffers.output, keep);
  CHECK(small.run(4) == expected);
  // With settings that need other kernels, too.
  keep.settings = Settings();
  keep.settings->set("taa", "off");
  small.denoiser.prepare(small.buffers.frame, small.buffers.output, keep);
  CHECK_FALSE(small.denoiser.settings().isOn("taa"));
  SmallDenoiser reset;
  CHECK(meanError(small.run(5).linear, untouched.run(5).linear) <
        0.5 * meanError(reset.run(5).linear, untouched.run(5).linear));
}

TEST_CASE("the history outlives a change of size", "[core]") {
  constexpr int kBefore = 11;
  ImageSetup larger;
  larger.size = {64, 36};
  SmallDenoiser small, untouched(larger), reset(larger);
  small.run(0, kBefore);
  const Picture expected = untouched.run(0, kBefore + 1);
  FrameBuffers buffers(small.device, larger);
  PrepareOptions keep;
  keep.keepHistory = true;
  small.denoiser.prepare(buffers.frame, buffers.output, keep);
  buffers.upload(kBefore + 1);
  small.denoiser.denoise(buffers.frame, buffers.output).wait();
  const double kept = meanError(buffers.download().linear, expected.linear);
  const double lost = meanError(reset.run(kBefore + 1).linear, expected.linear);
  INFO("kept " << kept << ", lost " << lost);
  CHECK(kept < 0.7 * lost);
}

TEST_CASE("pixels of another size take the nearest one", "[core]") {
  const BufferSpec spec{"lengths", Element::UInt8, Extent(2), true, 0, 0};
  const Size oldSize{2, 2}, newSize{4, 1};
  std::vector<unsigned char> old(elementCount(spec, oldSize));
  forEachElement(spec, oldSize, [&](std::size_t element, std::size_t i) {
    old[element] = static_cast<unsigned char>(i + 1);
  });
  const std::vector<unsigned char> resampled = resampleNearest(old, spec, oldSize, newSize);
  std::vector<int> values(8);
  forEachElement(spec, newSize, [&](std::size_t element, std::size_t i) { values[i] = resampled[element]; });
  CHECK(values == std::vector<int>{3, 3, 4, 4, 7, 7, 8, 8});  // the lower row is as near as the upper one
}

}  // namespace quell::tests
