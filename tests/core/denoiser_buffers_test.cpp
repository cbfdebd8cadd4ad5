// Intermediate buffers: which there are, what they hold, and that keeping them changes nothing.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

Options keeping(std::vector<std::string> names) {
  Options options = testOptions();
  options.keptBuffers = std::move(names);
  return options;
}

/// A kept image of three planes as the outputs are stored.
std::vector<float> pixelsOf(const BufferContent& content) {
  REQUIRE(content.planes == 3);
  const std::size_t count = content.values.size() / 3;
  std::vector<float> pixels;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t plane = 0; plane < 3; ++plane) pixels.push_back(content.values[plane * count + i]);
  return pixels;
}

void checkShape(const BufferContent& content, Size size) {
  INFO(content.name);
  CHECK(content.values.size() ==
        std::size_t(content.width) * std::size_t(content.height) * std::size_t(content.planes));
  CHECK_FALSE(content.values.empty());
  CHECK(std::all_of(content.values.begin(), content.values.end(), [](float v) { return std::isfinite(v); }));
  if (content.height == 1) return;  // records
  CHECK(content.width == size.width);
  CHECK(content.height == size.height);
}

/// Settings under which a method has buffers of every element.
Settings settingsOf(const std::string& method) {
  Settings settings(method);
  if (method == "bmfr") settings.set("featureStorage", "half");
  return settings;
}

}  // namespace

TEST_CASE("a history holds what the latest frame has left, whichever side that is on", "[core]") {
  Settings settings;
  settings.set("jitteredRays", "on");
  SmallDenoiser small({}, testOptions(), 0, settings);
  for (int number = 0; number < 3; ++number) {
    const Picture picture = small.run(number);
    const BufferContent content = small.denoiser.readBuffer("antialiased");
    CHECK(content.name == "antialiased");
    CHECK(pixelsOf(content) == picture.linear.pixels);
  }
}

TEST_CASE("a kept buffer holds its content although later stages have run", "[core]") {
  Settings plain;
  plain.set("taa", "off");
  SmallDenoiser expected({}, testOptions(), 0, plain);
  SmallDenoiser small({}, keeping({"beforeAntialiasing", "irradiance"}));
  for (int number = 0; number < 3; ++number) {
    small.run(number);
    CHECK(pixelsOf(small.denoiser.readBuffer("beforeAntialiasing")) == expected.run(number).linear.pixels);
  }
}

TEST_CASE("integers come as numbers", "[core]") {
  ImageSetup setup;
  setup.objectId = {ComponentFormat::UInt32, 1};
  SmallDenoiser small(setup, testOptions(), 0, Settings("svgf"));
  std::vector<cl_uint> ids(std::size_t(setup.size.width) * std::size_t(setup.size.height));
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = cl_uint(i);
  small.device.queue.enqueueWriteBuffer(cl::Buffer(small.buffers.frame.objectId.memory, true), CL_TRUE, 0,
                                        ids.size() * sizeof(cl_uint), ids.data());
  small.enqueue().wait();
  CHECK(small.denoiser.readBuffer("objectIds").values == std::vector<float>(ids.begin(), ids.end()));
}

TEST_CASE("all buffers of every method may be kept, at the cost of memory alone", "[core]") {
  for (const std::string& method : methodNames()) {
    INFO(method);
    SmallDenoiser plain({}, testOptions(), 0, settingsOf(method));
    const auto memory = plain.denoiser.memoryUse().buffers;
    const bool shares = std::any_of(memory.begin(), memory.end(), [](const MemoryUse::Buffer& buffer) {
      return buffer.name.find(" + ") != std::string::npos;
    });
    if (method == "quell" || method == "bmfr" || method == "svgf") CHECK(shares);
    if (method == "atrous") CHECK_FALSE(shares);  // its buffers are all in use to the end
    const std::vector<std::string> names = plain.denoiser.bufferNames();
    REQUIRE_FALSE(names.empty());
    SmallDenoiser small({}, keeping(names), 0, settingsOf(method));
    CHECK(small.denoiser.bufferNames() == names);
    CHECK(small.run(0, 1) == plain.run(0, 1));
    for (const std::string& name : names)
      checkShape(small.denoiser.readBuffer(name), small.buffers.frame.size);
    const std::size_t kept = small.denoiser.memoryUse().totalBytes,
                      least = plain.denoiser.memoryUse().totalBytes;
    CHECK((shares ? kept > least : kept == least));
  }
}

TEST_CASE("buffers that are unknown, not kept or not there yet are refused", "[core]") {
  SmallDenoiser small({}, keeping({"beforeAntialiasing"}));
  const auto read = [&](const char* name) { return [&, name] { small.denoiser.readBuffer(name); }; };
  const Refusal early{ErrorCode::NotPrepared, "readBuffer", "beforeAntialiasing", "a frame", "none"};
  checkRefused(early, read("beforeAntialiasing"));
  small.run(0);
  CHECK_NOTHROW(read("beforeAntialiasing")());
  checkRefused({ErrorCode::InvalidArgument, "readBuffer", "variance", "keptBuffers", "share"},
               read("variance"));
  checkRefused({ErrorCode::InvalidArgument, "readBuffer", "name", "antialiased", "nothing"}, read("nothing"));
  small.denoiser.resetHistory();
  checkRefused(early, read("beforeAntialiasing"));
}

TEST_CASE("prepare() refuses to keep what the method does not have and says what it has", "[core]") {
  OpenDevice device;
  const FrameBuffers buffers(device, {});
  Denoiser denoiser(device.context, device.device, device.queue, Settings(),
                    keeping({"beforeAntialiasing", "nothing"}));
  CHECK(denoiser.bufferNames().empty());
  const auto prepare = [&] { denoiser.prepare(buffers.frame, buffers.output); };
  checkRefused({ErrorCode::InvalidArgument, "prepare", "options.keptBuffers", "antialiased", "nothing"},
               prepare);
  CHECK(denoiser.bufferNames().empty());
  CHECK(denoiser.memoryUse().totalBytes == 0);
}

}  // namespace quell::tests
