// One sample of rare brightness does not stay visible, and many of them keep their light.
#include <catch2/catch.hpp>
#include <random>

#include "tests/pipelines/signal_images.hpp"

namespace quell::tests {
namespace {

constexpr int kWidth = 121, kHeight = 77, kFrames = 10;
constexpr int kFireflyFrame = 5;
constexpr double kVisible = 0.1;  // difference of a colour between 0 and 1

// Surfaces of albedo 1 without emitters, in noisy light of mean 1/2.
void addNoise(io::FrameData& frame) {
  std::mt19937 generator(unsigned(frame.number) + 1);
  frame.albedo = image(frame, 3, 1.0f);
  frame.emission = io::Image();
  for (std::size_t i = 0; i < frame.radiance.pixels.size(); i += 3)
    std::fill_n(&frame.radiance.pixels[i], 3, float(double(generator()) / double(std::mt19937::max())));
}

// Index of the first pixel around which a wall is as wide as this.
std::size_t pixelOfWall(const io::Image& normal) {
  constexpr int kReach = 8;
  const auto isSame = [&](int x, int y, int dx, int dy) {
    double dot = 0.0;
    for (int c = 0; c < 3; ++c) dot += double(normal.at(x, y, c)) * normal.at(x + dx, y + dy, c);
    return dot > 0.999;
  };
  for (int y = kReach; y < kHeight - kReach; ++y) {
    for (int x = kReach; x < kWidth - kReach; ++x) {
      bool isWall = true;
      for (const int dy : {-kReach, 0, kReach})
        for (const int dx : {-kReach, 0, kReach}) isWall = isWall && isSame(x, y, dx, dy);
      if (isWall) return 3 * (std::size_t(y) * kWidth + std::size_t(x));
    }
  }
  throw std::logic_error("no wall");
}

std::vector<cli::DenoisedFrame> denoised(const Settings& settings, bool moving, float firefly) {
  const auto sequence = analyticSequence(kWidth, kHeight, kFrames, {0.0, 0.0, 0.0}, 0, moving);
  const auto edit = [&](io::FrameData& frame) {
    addNoise(frame);
    if (frame.number != kFireflyFrame || firefly == 0.0f) return;
    std::fill_n(&frame.radiance.pixels[pixelOfWall(frame.normalWorld)], 3, firefly);
  };
  return denoiseSequence(*sequence, firstFrames(kFrames), settings, {}, edit).frames;
}

// Pixels of the last frame that a firefly has visibly changed.
int visibleAfter(const Settings& settings, bool moving, float firefly) {
  const io::Image without = denoised(settings, moving, 0.0f).back().linear;
  const io::Image with = denoised(settings, moving, firefly).back().linear;
  int visible = 0;
  for (std::size_t i = 0; i < with.pixels.size(); i += 3)
    visible += std::abs(std::min(with.pixels[i], 1.0f) - std::min(without.pixels[i], 1.0f)) > kVisible;
  return visible;
}

// Every sample sees a lamp that is this much brighter than the mean with the inverse probability, else nothing.
constexpr unsigned kHitBrightness = 50;

void sparseHits(io::FrameData& frame) {
  std::mt19937 generator(unsigned(frame.number) + 1);
  const auto pixels = std::size_t(frame.radiance.width) * std::size_t(frame.radiance.height);
  for (std::size_t i = 0; i < pixels; ++i) {
    const bool hit = generator() < std::mt19937::max() / kHitBrightness;
    std::fill_n(&frame.radiance.pixels[3 * i], 3, hit ? float(kHitBrightness) : 0.0f);
  }
  std::fill(frame.albedo.pixels.begin(), frame.albedo.pixels.end(), 1.0f);
  std::fill(frame.emission.pixels.begin(), frame.emission.pixels.end(), 0.0f);
}

// Light of the last of some frames of sparse hits, relative to the mean of what came in.
Light denoiseHits(const Settings& settings, int frames = 8) {
  const auto sequence = analyticSequence(320, 180, frames, {0.0, 0.0, 0.0}, 0, false);
  const io::Image normal = sequence->read(0).normalWorld;
  double input = 0.0;
  const auto result =
      denoiseSequence(*sequence, firstFrames(frames), settings, {}, [&](io::FrameData& frame) {
        sparseHits(frame);
        input += lightOf(frame.radiance, normal).mean / frames;
      });
  Light light = lightOf(result.frames.back().linear, normal);
  return {light.mean / input, light.deviation / input};
}

}  // namespace

TEST_CASE("a firefly is gone from the picture a few frames later", "[pipelines]") {
  for (const char* method : {"quell", "svgf", "bmfr", "atrous"}) {
    for (const float firefly : {30.0f, 1000.0f, 1e30f}) {
      INFO(method << ", sample of " << firefly);
      CHECK(visibleAfter(Settings(method), false, firefly) == 0);
    }
  }
}

TEST_CASE("a firefly that moves on the screen is gone as well", "[pipelines]") {
  for (const char* method : {"quell", "svgf", "bmfr"}) {
    INFO(method);
    CHECK(visibleAfter(Settings(method), true, 1000.0f) <= 2);
  }
}

TEST_CASE("fireflies stay where the filter is told to leave them their weight", "[pipelines]") {
  for (const char* method : {"quell", "bmfr"}) {
    INFO(method);
    Settings settings(method);
    settings.set("fireflyRatio", 0.0);
    CHECK(visibleAfter(settings, false, 1000.0f) > 5);
  }
}

TEST_CASE("quell keeps the light of sparse lamp hits", "[pipelines]") {
  const Light kept = denoiseHits(Settings("quell"));
  Settings losing("quell");
  losing.set("keepLight", 0.0);
  const Light lost = denoiseHits(losing);
  INFO("light kept " << kept.mean << ", lost " << lost.mean);
  CHECK(kept.mean == Approx(1.0).epsilon(0.03));
  CHECK(lost.mean < 0.9);
}

TEST_CASE("light that comes by rare samples is kept", "[pipelines]") {
  for (const char* method : {"quell", "svgf", "bmfr"}) {
    INFO(method);
    // The history of svgf is worth two frames: more hits are alone in it.
    const bool remembers = method != std::string("svgf");
    CHECK(denoiseHits(Settings(method), kFrames).mean == Approx(1.0).epsilon(remembers ? 0.04 : 0.1));
  }
}

}  // namespace quell::tests
