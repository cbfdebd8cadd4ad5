#include "host/io/light_remainder.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/test_images.hpp"

using namespace quell::io;
using quell::tests::samePixels;

namespace {

/// One pixel: what it is made of, and the light as a whole.
struct Pixel {
  float albedo, diffuse, glossColor, glossy, emission, whole, transmission;
  bool background = false;
};

FrameData frameOf(const std::vector<Pixel>& pixels) {
  const int width = int(pixels.size());
  FrameData frame;
  frame.demodulated = true;
  for (Image* image : {&frame.albedo, &frame.radiance, &frame.glossColor, &frame.glossyRadiance,
                       &frame.emission, &frame.combined, &frame.normalWorld})
    *image = Image(width, 1, 3);
  for (int x = 0; x < width; ++x) {
    for (int c = 0; c < 3; ++c) {
      const Pixel& pixel = pixels[std::size_t(x)];
      frame.albedo.at(x, 0, c) = pixel.albedo;
      frame.radiance.at(x, 0, c) = pixel.diffuse;
      frame.glossColor.at(x, 0, c) = pixel.glossColor;
      frame.glossyRadiance.at(x, 0, c) = pixel.glossy;
      frame.emission.at(x, 0, c) = pixel.emission;
      frame.combined.at(x, 0, c) = pixel.whole;
      frame.normalWorld.at(x, 0, c) = pixel.background ? 0.0f : 1.0f;
    }
  }
  return frame;
}

Image transmissionOf(const std::vector<Pixel>& pixels) {
  Image image(int(pixels.size()), 1, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = pixels[i / 3].transmission;
  return image;
}

float explained(const FrameData& frame, int x) {
  return frame.albedo.at(x, 0, 1) * frame.radiance.at(x, 0, 1) +
         frame.glossColor.at(x, 0, 1) * frame.glossyRadiance.at(x, 0, 1) + frame.emission.at(x, 0, 1);
}

const Pixel kDiffuse{0.5f, 2.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f};
const Pixel kGlass{0.0f, 0.0f, 0.25f, 0.5f, 0.0f, 2.125f, 0.5f};
const Pixel kSkin{0.5f, 1.0f, 0.0f, 0.0f, 0.0f, 1.5f, 0.0f};
const Pixel kFog{0.0f, 0.0f, 0.0f, 0.0f, 0.25f, 1.0f, 0.0f, true};

}  // namespace

TEST_CASE("light that diffuse and glossy passes do not explain stays in the frame") {
  const std::vector<Pixel> pixels = {kDiffuse, kGlass, kSkin, kFog};
  FrameData frame = frameOf(pixels);
  keepRemainder(frame, transmissionOf(pixels));
  for (int x = 0; x < int(pixels.size()); ++x) CHECK(explained(frame, x) == pixels[std::size_t(x)].whole);
  CHECK(frame.albedo.at(0, 0, 0) == 0.5f);  // its light is whole
  CHECK(frame.radiance.at(0, 0, 0) == 2.0f);
  CHECK(frame.albedo.at(1, 0, 0) == 0.5f);  // the colour of transmission
  CHECK(frame.emission.at(3, 0, 0) == 1.0f);
  CHECK(frame.albedo.at(3, 0, 0) == 0.0f);
}

TEST_CASE("without a transmission colour what has no albedo counts as white") {
  FrameData frame = frameOf({kGlass});
  keepRemainder(frame, Image());
  CHECK(frame.albedo.at(0, 0, 0) == 1.0f);
  CHECK(explained(frame, 0) == kGlass.whole);
}

TEST_CASE("rounding and broken samples are no remainder") {
  std::vector<Pixel> pixels = {kDiffuse, kDiffuse, kDiffuse};
  pixels[0].whole *= 1.01f;
  pixels[1].whole *= 0.5f;  // less than its parts
  pixels[2].whole = std::numeric_limits<float>::quiet_NaN();
  FrameData frame = frameOf(pixels);
  const FrameData before = frame;
  keepRemainder(frame, transmissionOf({kGlass, kGlass, kGlass}));
  CHECK(samePixels(frame.radiance, before.radiance));
  CHECK(samePixels(frame.albedo, before.albedo));
  CHECK(samePixels(frame.emission, before.emission));
}
