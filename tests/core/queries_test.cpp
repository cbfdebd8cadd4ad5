// What a method reads, and how much memory it takes, before anything is built.
#include <catch2/catch.hpp>
#include <map>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

std::map<std::string, InputUse> usesOf(const Settings& settings) {
  std::map<std::string, InputUse> uses;
  for (const InputNeed& need : inputNeeds(settings)) uses[need.image] = need.use;
  return uses;
}

}  // namespace

TEST_CASE("a method says which images it reads", "[core]") {
  auto uses = usesOf(Settings());
  CHECK(uses["radiance"] == InputUse::Required);
  CHECK(uses["normalWorld"] == InputUse::Required);
  CHECK(uses["positionWorld"] == InputUse::Required);
  CHECK(uses["albedo"] == InputUse::Optional);
  CHECK(uses["motion"] == InputUse::Optional);
  CHECK(uses["roughness"] == InputUse::Optional);
  CHECK(uses["hitDistance"] == InputUse::Unused);
  CHECK(uses["f0"] == InputUse::Unused);
  CHECK(usesOf(Settings("atrous"))["motion"] == InputUse::Unused);
  for (const InputNeed& need : inputNeeds(Settings()))
    if (need.image == "viewDepth") CHECK(need.without == "positionWorld");
}

TEST_CASE("settings change what is read", "[core]") {
  Settings fBeta;
  fBeta.set("demodulate", "fbeta");
  CHECK(usesOf(fBeta)["roughness"] == InputUse::Required);
  CHECK(usesOf(fBeta)["f0"] == InputUse::Optional);
  Settings features("bmfr");
  features.set("features", "n,w,albedo");
  CHECK(usesOf(features)["albedo"] == InputUse::Required);
}

TEST_CASE("memory is known before it is allocated", "[core]") {
  for (const std::string& method : methodNames()) {
    INFO(method);
    const OpenDevice device;
    const FrameBuffers buffers(device, {});
    Denoiser denoiser(device.context, device.device, device.queue, Settings(method), testOptions());
    Frame frame = buffers.frame;
    frame.albedo = summed(packedImage(frame.albedo.memory, 3), Sum::OverSampleCount);
    const MemoryUse needed = denoiser.memoryNeeded(frame, buffers.output);
    CHECK(denoiser.memoryUse().totalBytes == 0);
    if (method != "quell" && method != "atrous") continue;
    denoiser.prepare(frame, buffers.output);
    CHECK(denoiser.memoryUse().totalBytes == needed.totalBytes);
    CHECK(denoiser.memoryUse().buffers.size() == needed.buffers.size());
  }
}

TEST_CASE("memory for an unusable layout is refused", "[core]") {
  const OpenDevice device;
  const FrameBuffers buffers(device, {});
  const Denoiser denoiser(device.context, device.device, device.queue, Settings(), testOptions());
  Frame frame = buffers.frame;
  frame.normalWorld = {};
  checkRefused({ErrorCode::InvalidArgument, "prepare", "normalWorld", "an image", "none"},
               [&] { denoiser.memoryNeeded(frame, buffers.output); });
}

}  // namespace quell::tests
