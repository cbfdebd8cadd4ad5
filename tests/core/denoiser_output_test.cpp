// Outputs: which ones, in which layout, and that nothing else is written.
#include <catch2/catch.hpp>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kLastFrame = 2;

io::Image firstChannels(const io::Image& image) {
  io::Image result(image.width, image.height, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) result.at(x, y, c) = image.at(x, y, c);
  return result;
}

bool fourthIsOne(const io::Image& image) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.at(x, y, 3) != 1.0f) return false;
  return true;
}

io::Image roundedToHalf(const io::Image& image) {
  return asStored(image, packedImage(nullptr, image.channels, ComponentFormat::Float16));
}

// One output of a denoiser against the same one as packed floats.
void checkOutput(const SmallDenoiser& small, const ImageView& view, const io::Image& got,
                 const io::Image& expected) {
  const bool half = view.format == ComponentFormat::Float16;
  CHECK(firstChannels(got).pixels == (half ? roundedToHalf(expected) : expected).pixels);
  CHECK(gapsUntouched(small.buffers.bytes(view), view, small.buffers.frame.size));
  if (view.channels == 4) CHECK(fourthIsOne(got));
}

struct OutputLayouts {
  ImageLayout linear, display;
};

}  // namespace

TEST_CASE("outputs of every layout hold the same picture and leave the gaps alone", "[core]") {
  const Picture expected = SmallDenoiser().run(0, kLastFrame);
  const OutputLayouts outputs[] = {{packed(4), interleaved(3)},
                                   {packedHalf(3), packedHalf(4)},
                                   {interleaved(4, ComponentFormat::Float16), interleaved(4)}};
  for (const OutputLayouts& layouts : outputs) {
    INFO(describe(layouts.linear) << ", " << describe(layouts.display));
    ImageSetup setup;
    setup.linear = layouts.linear;
    setup.display = layouts.display;
    SmallDenoiser small(setup);
    const Picture picture = small.run(0, kLastFrame);
    checkOutput(small, small.buffers.output.linear, picture.linear, expected.linear);
    checkOutput(small, small.buffers.output.display, picture.display, expected.display);
  }
}

TEST_CASE("either output may be left out", "[core]") {
  const Picture both = SmallDenoiser().run(0, kLastFrame);
  ImageSetup linearOnly, displayOnly;
  linearOnly.display = absent();
  displayOnly.linear = absent();
  CHECK(SmallDenoiser(linearOnly).run(0, kLastFrame).linear.pixels == both.linear.pixels);
  CHECK(SmallDenoiser(displayOnly).run(0, kLastFrame).display.pixels == both.display.pixels);
}

TEST_CASE("a frame with linear output alone takes less memory", "[core]") {
  ImageSetup linearOnly;
  linearOnly.display = absent();
  CHECK(SmallDenoiser(linearOnly).denoiser.memoryUse().totalBytes <
        SmallDenoiser().denoiser.memoryUse().totalBytes);
}

TEST_CASE("without temporal antialiasing the display output is the encoded linear one", "[core]") {
  Settings settings;
  settings.set("taa", "off");
  SmallDenoiser plain({}, testOptions(), 0, settings);
  const Picture picture = plain.run(0, kLastFrame);
  CHECK(picture.linear.pixels == SmallDenoiser().run(0, kLastFrame).linear.pixels);
  double largest = 0.0;
  for (std::size_t i = 0; i < picture.linear.pixels.size(); ++i) {
    const double encoded = std::pow(std::min(1.0, double(picture.linear.pixels[i])), 1.0 / 2.2);
    largest = std::max(largest, std::abs(encoded - picture.display.pixels[i]));
  }
  CHECK(largest < 1e-5);
}

TEST_CASE("the linear output may be antialiased, for tone maps of one's own", "[core]") {
  Settings settings;
  settings.set("antialiasLinear", "on");
  settings.set("toneMap", "none");
  settings.set("displayEncoding", "linear");
  const Picture both = SmallDenoiser({}, testOptions(), 0, settings).run(0, kLastFrame);
  CHECK(both.linear.pixels == both.display.pixels);
  const Picture usual = SmallDenoiser().run(0, kLastFrame);
  CHECK_FALSE(both.linear.pixels == usual.linear.pixels);
  ImageSetup linearOnly;
  linearOnly.display = absent();
  settings = Settings();
  settings.set("antialiasLinear", "on");
  CHECK(SmallDenoiser(linearOnly, testOptions(), 0, settings).run(0, kLastFrame).linear.pixels ==
        both.linear.pixels);
  CHECK(SmallDenoiser({}, testOptions(), 0, settings).run(0, kLastFrame).display.pixels ==
        usual.display.pixels);
}

}  // namespace quell::tests
