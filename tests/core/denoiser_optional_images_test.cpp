// Images that may be left out, and depth in place of positions.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kLastFrame = 3;

bool isClean(const io::Image& image, float most) {
  for (const float value : image.pixels)
    if (!(value >= 0.0f && value <= most)) return false;
  return !image.pixels.empty();
}

double rmse(const io::Image& a, const io::Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::pow(double(a.pixels[i]) - b.pixels[i], 2.0);
  return std::sqrt(sum / double(a.pixels.size()));
}

}  // namespace

TEST_CASE("grey radiance is spread to three channels, and a constant gloss colour alone changes nothing",
          "[core]") {
  ImageSetup grey, spread;
  grey.albedo = grey.emission = spread.albedo = spread.emission = absent();
  grey.radiance = packed(1);
  spread.glossColor = packed(3);  // 1/4 everywhere: all irradiance is scaled by 4 and back, without rounding
  // The filter of quell has a least step of luminance, which does not scale.
  const Settings bmfr("bmfr");
  SmallDenoiser one(grey, testOptions(), 0, bmfr), three(spread, testOptions(), 0, bmfr);
  const Size size = grey.size;
  const io::Image values =
      decodeImage(one.buffers.bytes(one.buffers.frame.radiance), one.buffers.frame.radiance, size);
  io::Image equal(size.width, size.height, 3);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (int c = 0; c < 3; ++c) equal.at(x, y, c) = values.at(x, y, 0);
  three.device.queue.enqueueWriteBuffer(cl::Buffer(three.buffers.frame.radiance.memory, true), CL_TRUE, 0,
                                        equal.pixels.size() * sizeof(float), equal.pixels.data());
  one.enqueue().wait();
  three.enqueue().wait();
  const Picture picture = one.buffers.download();
  CHECK(isClean(picture.linear, 65504.0f));
  CHECK(isClean(picture.display, 1.0f));
  CHECK(three.buffers.download() == picture);
}

TEST_CASE("gloss colour is added to the albedo", "[core]") {
  ImageSetup withGloss;
  withGloss.glossColor = packed(3);
  SmallDenoiser two(withGloss), one;
  const ImageView& view = one.buffers.frame.albedo;
  io::Image factor = decodeImage(one.buffers.bytes(view), view, one.buffers.frame.size);
  const auto writeAlbedo = [&](SmallDenoiser& small) {
    small.device.queue.enqueueWriteBuffer(cl::Buffer(small.buffers.frame.albedo.memory, true), CL_TRUE, 0,
                                          factor.pixels.size() * sizeof(float), factor.pixels.data());
  };
  for (float& value : factor.pixels) value *= 0.5f;  // both together stay below 1
  writeAlbedo(two);
  for (float& value : factor.pixels) value += 0.25f;
  writeAlbedo(one);
  one.enqueue().wait();
  two.enqueue().wait();
  CHECK(one.buffers.download() == two.buffers.download());
}

TEST_CASE("an absent image's memory is not looked at", "[core]") {
  SmallDenoiser small;
  const Picture expected = small.run(0);
  small.denoiser.resetHistory();
  const OpenDevice other;
  const cl::Buffer foreign(other.context, CL_MEM_READ_WRITE, 16);
  small.buffers.frame.glossColor.memory = foreign();
  CHECK(small.run(0) == expected);
}

TEST_CASE("view depth gives nearly the same picture as positions", "[core]") {
  ImageSetup depth;
  depth.positionWorld = absent();
  depth.viewDepth = packed(1);
  const Picture fromPosition = SmallDenoiser().run(0, kLastFrame);
  const Picture fromDepth = SmallDenoiser(depth).run(0, kLastFrame);
  CHECK(rmse(fromPosition.display, fromDepth.display) < 0.01);
  CHECK(isClean(fromDepth.linear, 65504.0f));
}

TEST_CASE("object ids of 32 bits are told apart to the last bit", "[core]") {
  ImageSetup setup;
  setup.objectId = {ComponentFormat::UInt32, 1};
  const auto run = [&](cl_uint first, cl_uint second) {
    SmallDenoiser small(setup);
    for (int number = 0; number < 2; ++number) {
      small.buffers.upload(number);
      const std::vector<cl_uint> ids(std::size_t(setup.size.width) * std::size_t(setup.size.height),
                                     number == 0 ? first : second);
      small.device.queue.enqueueWriteBuffer(cl::Buffer(small.buffers.frame.objectId.memory, true), CL_TRUE, 0,
                                            ids.size() * sizeof(cl_uint), ids.data());
      small.enqueue().wait();
    }
    return small.buffers.download();
  };
  const Picture plain = SmallDenoiser().run(0, 1);
  CHECK(run(0xFFFFFFFE, 0xFFFFFFFE) == plain);
  CHECK(run(7, 7) == plain);
  CHECK_FALSE(run(0xFFFFFFFE, 0xFFFFFFFF).linear.pixels == plain.linear.pixels);
}

TEST_CASE("motion vectors win over the matrices", "[core]") {
  ImageSetup setup;
  setup.motion = packedHalf(2);
  setup.objectId = packed(1);
  const auto run = [](SmallDenoiser& small, bool stillCamera) {
    small.run(0);
    small.buffers.upload(1);
    if (stillCamera) small.buffers.frame.camera.worldToClipPrev = small.buffers.frame.camera.worldToClip;
    small.enqueue().wait();
    return small.buffers.download();
  };
  SmallDenoiser one(setup), two(setup);
  const Picture picture = run(one, false);
  CHECK(isClean(picture.linear, 65504.0f));
  CHECK(isClean(picture.display, 1.0f));
  CHECK(run(two, true) == picture);
  SmallDenoiser plain;
  CHECK_FALSE(run(plain, false) == picture);
}

TEST_CASE("hit distances are taken, and change nothing yet", "[core]") {
  ImageSetup setup;
  setup.hitDistance = packedHalf(1);
  CHECK(SmallDenoiser(setup).run(0, kLastFrame) == SmallDenoiser().run(0, kLastFrame));
}

TEST_CASE("radiance may come demodulated, without emission", "[core]") {
  const OpenDevice device;
  ImageSetup setup;
  setup.emission = absent();
  FrameBuffers buffers(device, setup);
  buffers.frame.demodulated = true;
  Denoiser denoiser(device.context, device.device, device.queue, Settings(), testOptions());
  denoiser.prepare(buffers.frame, buffers.output);
  denoiser.denoise(buffers.frame, buffers.output).wait();
  const Picture picture = buffers.download();
  CHECK(isClean(picture.linear, 65504.0f));
  CHECK_FALSE(picture == SmallDenoiser().run(0));
}

}  // namespace quell::tests
