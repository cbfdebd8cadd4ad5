// Leaving out background changes no method's picture.
#include <catch2/catch.hpp>

#include "tests/pipelines/signal_images.hpp"

namespace quell::tests {
namespace {

constexpr int kFrames = 3;
constexpr int kWidth = 121, kHeight = 77;

struct Variant {
  std::string method;
  bool twoSignals = false;
  bool gram = false;
  bool motion = false;
};

std::unique_ptr<io::FrameSequence> sequenceWithSky() {
  io::AnalyticOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.frameCount = kFrames;
  options.skyShare = 0.4;
  return io::makeAnalyticSequence(options);
}

double largestDifference(const io::Image& a, const io::Image& b) {
  double largest = 0.0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(double(a.at(x, y, c)) - b.at(x, y, c)));
  return largest;
}

void checkSkip(const io::FrameSequence& sequence, const Variant& variant, bool jittered) {
  const auto edit = [&](io::FrameData& frame) {
    if (variant.twoSignals) addGloss(frame);
    if (jittered) frame.camera.jitterPx = {0.25 * (frame.number % 2), -0.125};
    if (variant.motion) frame.motion = image(frame, 2, 1.75f);  // the sky runs over the surfaces
  };
  const auto denoise = [&](const char* skip) {
    Settings settings(variant.method);
    settings.set("skip", skip);
    if (variant.gram) settings.set("solver", "gram");
    return denoiseSequence(sequence, firstFrames(kFrames), settings, {}, edit).frames;
  };
  const auto all = denoise("off"), left = denoise("on");
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(variant.method << (variant.gram ? " gram" : "")
                        << (variant.twoSignals ? ", two signals" : ", one signal")
                        << (jittered ? ", jittered" : "") << (variant.motion ? ", motion" : "") << ", frame "
                        << i);
    CHECK(largestDifference(all[i].linear, left[i].linear) == 0.0);
    CHECK(largestDifference(all[i].display, left[i].display) == 0.0);
  }
}

}  // namespace

// Once with most stages and once with the fit of blocks: every variant compiles its kernels anew, and each stage's own test
// has them.
TEST_CASE("leaving out background changes no picture", "[pipelines]") {
  const auto sequence = sequenceWithSky();
  for (const Variant& variant : {Variant{"bmfr"}, Variant{"quell", true, false, true}})
    for (const bool jittered : {false, true}) checkSkip(*sequence, variant, jittered);
}

TEST_CASE("leaving out background changes no picture of any method", "[pipelines][.long]") {
  const auto sequence = sequenceWithSky();
  for (const Variant& variant : {Variant{"bmfr", false, true}, Variant{"svgf"}, Variant{"guided"},
                                 Variant{"edagi", true}, Variant{"atrous"}, Variant{"quell"}})
    for (const bool jittered : {false, true}) checkSkip(*sequence, variant, jittered);
}

}  // namespace quell::tests
