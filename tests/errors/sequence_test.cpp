// Calls in the wrong order, and frames that differ from what was prepared.
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

Refusal notPrepared(const std::string& buffer, const std::string& expected, const std::string& got) {
  return {ErrorCode::NotPrepared, "denoise", buffer, expected, got};
}

}  // namespace

TEST_CASE("denoising before prepare() is refused", "[errors]") {
  const OpenDevice device;
  FrameBuffers buffers(device, {});
  Denoiser denoiser(device.context, device.device, device.queue, Settings(), testOptions());
  checkRefused(notPrepared("", "prepare()", "none"),
               [&] { denoiser.denoise(buffers.frame, buffers.output); });
  CHECK_NOTHROW(denoiser.resetHistory());
  CHECK(denoiser.timings().frame.count == 0);
  denoiser.prepare(buffers.frame, buffers.output);
  CHECK_NOTHROW(denoiser.denoise(buffers.frame, buffers.output).wait());
}

TEST_CASE("a changed size is refused until it is prepared, and then the history starts afresh", "[errors]") {
  SmallDenoiser small;
  small.run(0, 1);
  ImageSetup larger;
  larger.size = {53, 30};
  FrameBuffers buffers(small.device, larger);
  checkRefused(notPrepared("size", "37x21", "53x30"),
               [&] { small.denoiser.denoise(buffers.frame, buffers.output); });
  const std::size_t before = small.denoiser.memoryUse().totalBytes;
  small.denoiser.prepare(buffers.frame, buffers.output);
  CHECK(small.denoiser.memoryUse().totalBytes > before);
  small.denoiser.denoise(buffers.frame, buffers.output).wait();
  CHECK(buffers.download() == SmallDenoiser(larger).run(0));
  small.denoiser.prepare(small.buffers.frame, small.buffers.output);
  CHECK(small.denoiser.memoryUse().totalBytes == before);
  const Picture first = small.run(0);
  small.denoiser.resetHistory();
  CHECK(small.run(0) == first);
  checkStillWorks(small);
}

TEST_CASE("a changed layout is refused by the image's name", "[errors]") {
  SmallDenoiser small;
  const Frame prepared = small.buffers.frame;
  const Output preparedOutput = small.buffers.output;
  const auto check = [&](const Refusal& refusal, const Frame& frame, const Output& output) {
    checkRefused(refusal, [&] { small.denoiser.denoise(frame, output); });
  };
  Frame frame = prepared;
  frame.radiance.channels = 4;
  check(notPrepared("radiance", "3 floats per pixel", "4 floats per pixel"), frame, preparedOutput);
  frame = prepared;
  frame.normalWorld.format = ComponentFormat::Float16;
  check(notPrepared("normalWorld", "3 floats", "3 halves"), frame, preparedOutput);
  frame = prepared;
  frame.positionWorld.pixelStrideBytes = 16;
  check(notPrepared("positionWorld", "pixel stride 12", "pixel stride 16"), frame, preparedOutput);
  frame = prepared;
  frame.albedo.rowPitchBytes = 512;
  check(notPrepared("albedo", "row pitch 444", "row pitch 512"), frame, preparedOutput);
  frame = prepared;
  frame.emission = {};
  check(notPrepared("emission", "3 floats", "absent"), frame, preparedOutput);
  frame = prepared;
  frame.glossColor = packedImage(prepared.albedo.memory, 3);
  check(notPrepared("glossColor", "absent", "3 floats"), frame, preparedOutput);
  Output output = preparedOutput;
  output.display = {};
  check(notPrepared("output.display", "3 floats", "absent"), prepared, output);
  checkStillWorks(small);
}

TEST_CASE("strides spelt out are the same layout as packed ones", "[errors]") {
  SmallDenoiser small;
  small.buffers.frame.radiance.pixelStrideBytes = 12;
  small.buffers.frame.radiance.rowPitchBytes = 37 * 12;
  checkStillWorks(small);
}

TEST_CASE("a broken layout is refused by denoise(), too", "[errors]") {
  SmallDenoiser small;
  Frame frame = small.buffers.frame;
  frame.radiance.offsetBytes = 2;
  checkRefused({ErrorCode::InvalidArgument, "denoise", "radiance", "an offset in multiples of 4 bytes", "2"},
               [&] { small.denoiser.denoise(frame, small.buffers.output); });
  checkStillWorks(small);
}

TEST_CASE("a changed demodulated flag is refused", "[errors]") {
  SmallDenoiser small;
  Frame frame = small.buffers.frame;
  frame.demodulated = true;
  checkRefused(notPrepared("demodulated", "false", "true"),
               [&] { small.denoiser.denoise(frame, small.buffers.output); });
  checkStillWorks(small);
}

}  // namespace quell::tests
