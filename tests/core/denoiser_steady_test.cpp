// After prepare() frames neither build programs nor allocate device memory.
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "host/core/program_cache.hpp"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

bool same(const ProgramCacheCounters& a, const ProgramCacheCounters& b) {
  return a.built == b.built && a.fromMemory == b.fromMemory && a.fromDisk == b.fromDisk;
}

cl_uint referencesOf(const cl::Context& context) { return context.getInfo<CL_CONTEXT_REFERENCE_COUNT>(); }

}  // namespace

TEST_CASE("frames build nothing and allocate nothing", "[core]") {
  SmallDenoiser small;
  small.run(0);
  const ProgramCacheCounters builds = ProgramCache::counters();
  const MemoryUse memory = small.denoiser.memoryUse();
  // Every OpenCL object holds a reference to the context: buffers, programs, kernels and events of frames
  // that are done would show here.
  small.device.queue.finish();
  const cl_uint references = referencesOf(small.device.context);
  for (int number = 1; number < 6; ++number) small.run(number);
  small.denoiser.resetHistory();
  small.run(6);
  small.device.queue.finish();
  CHECK(same(ProgramCache::counters(), builds));
  CHECK(small.denoiser.memoryUse().totalBytes == memory.totalBytes);
  // Runtimes may drop the last references of a finished queue a moment later: ten seconds at most.
  for (int attempt = 0; attempt < 10000 && referencesOf(small.device.context) > references; ++attempt)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  CHECK(referencesOf(small.device.context) <= references);
}

TEST_CASE("the memory in use is the sum over the buffers and none before prepare()", "[core]") {
  SmallDenoiser small;
  std::size_t sum = 0;
  for (const MemoryUse::Buffer& buffer : small.denoiser.memoryUse().buffers) {
    CHECK_FALSE(buffer.name.empty());
    CHECK(buffer.bytes > 0);
    sum += buffer.bytes;
  }
  CHECK(sum > 0);
  CHECK(small.denoiser.memoryUse().totalBytes == sum);
  const Denoiser fresh(small.device.context, small.device.device, small.device.queue, Settings(),
                       testOptions());
  CHECK(fresh.memoryUse().totalBytes == 0);
}

TEST_CASE("handles and wrappers of clhpp construct the same denoiser", "[core]") {
  SmallDenoiser small;  // from wrappers
  const Picture expected = small.run(0);
  small.buffers.upload(0);
  Denoiser fromHandles(small.device.context(), small.device.device(), small.device.queue(), Settings(),
                       testOptions());
  fromHandles.prepare(small.buffers.frame, small.buffers.output);
  fromHandles.denoise(small.buffers.frame, small.buffers.output).wait();
  CHECK(small.buffers.download() == expected);
  CHECK(fromHandles.settings().method() == "quell");
}

TEST_CASE("a denoiser keeps the settings it was made with", "[core]") {
  const OpenDevice device;
  Settings settings("bmfr");
  settings.set("noisyLeastWeight", 0.5);
  const Denoiser denoiser(device.context, device.device, device.queue, settings, testOptions());
  settings.set("noisyLeastWeight", 0.25);
  CHECK(denoiser.settings().get("noisyLeastWeight") == 0.5);
}

}  // namespace quell::tests
