// One sample of rare brightness does not stay visible, and many of them keep their light.
#include <catch2/catch.hpp>
#include <random>

#include "tests/pipelines/signal_images.hpp"

namespace quell::tests {
namespace {

constexpr int kWidth = 121, kHeight = 77, kFrames = 10;
constexpr int kFireflyFrame = 5;
constexpr double kVisible = 0.1;  // difference of a colour between 0 and 1

double uniform(std::mt19937& generator) { return double(generator()) / double(std::mt19937::max()); }

// Surfaces of albedo 1 without emitters, in light of mean 1/2.
template <class Noise>
void lightEvenly(io::FrameData& frame, Noise&& noise) {
  std::mt19937 generator(unsigned(frame.number) + 1);
  frame.albedo = image(frame, 3, 1.0f);
  frame.emission = io::Image();
  for (std::size_t i = 0; i < frame.radiance.pixels.size(); i += 3)
    std::fill_n(&frame.radiance.pixels[i], 3, float(0.5 * noise(generator)));
}

void addNoise(io::FrameData& frame) {
  lightEvenly(frame, [](std::mt19937& generator) { return 2.0 * uniform(generator); });
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

// Mean of the last frame's surfaces, relative to that of what came in, where a lamp is hit by one sample in fifty.
double lightOfSparseHits(const char* method) {
  constexpr double kBrightness = 50.0;
  const auto sequence = analyticSequence(320, 180, kFrames, {0.0, 0.0, 0.0}, 0, false);
  const io::Image normal = sequence->read(0).normalWorld;
  const auto meanOf = [&](const io::Image& light) {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < normal.pixels.size(); i += 3) {
      if (normal.pixels[i] == 0.0f && normal.pixels[i + 1] == 0.0f && normal.pixels[i + 2] == 0.0f) continue;
      sum += light.pixels[i];
      count += 1.0;
    }
    return sum / count;
  };
  double input = 0.0;
  const auto edit = [&](io::FrameData& frame) {
    lightEvenly(frame, [](std::mt19937& generator) {
      return uniform(generator) < 1.0 / kBrightness ? kBrightness : 0.0;
    });
    input += meanOf(frame.radiance) / kFrames;
  };
  const auto result = denoiseSequence(*sequence, firstFrames(kFrames), Settings(method), {}, edit);
  return meanOf(result.frames.back().linear) / input;
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

TEST_CASE("light that comes by rare samples is kept", "[pipelines]") {
  for (const char* method : {"quell", "svgf", "bmfr"}) {
    INFO(method);
    // The history of svgf is worth two frames: more hits are alone in it.
    const bool remembers = method != std::string("svgf");
    CHECK(lightOfSparseHits(method) == Approx(1.0).epsilon(remembers ? 0.04 : 0.1));
  }
}

}  // namespace quell::tests
