#include "host/stress/frame_families.hpp"

#include <limits>

#include "host/analytic/sequence.hpp"

namespace quell::stress {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kFirefly = 1e30f;

// Calls work(x, y) for this share of the pixels where faults may lie.
template <class Work>
void forSome(double share, Random& random, Work&& work) {
  for (int y = 0; y < kFaultEdge; ++y)
    for (int x = 0; x < kFaultEdge; ++x)
      if (random.chance(share)) work(x, y);
}

void setPixel(io::Image& image, int x, int y, float value) {
  for (int c = 0; c < image.channels; ++c) image.at(x, y, c) = value;
}

float brokenValue(Random& random) {
  constexpr float kBroken[] = {kNan, kInfinity, -kInfinity};
  return kBroken[random.integer(0, 2)];
}

void addFireflies(io::FrameData& frame, Random& random) {
  forSome(0.02, random, [&](int x, int y) { frame.radiance.at(x, y, random.integer(0, 2)) = kFirefly; });
}

void addDenormals(io::FrameData& frame, Random& random) {
  for (float& value : frame.radiance.pixels) value = static_cast<float>(random.uniform(0.0, 1e-38));
}

void addZeros(io::FrameData& frame, Random&) {
  for (float& value : frame.radiance.pixels) value = 0.0f;
}

void addNegatives(io::FrameData& frame, Random& random) {
  forSome(0.5, random, [&](int x, int y) { frame.radiance.at(x, y, random.integer(0, 2)) *= -1.0f; });
}

void breakRadiance(io::FrameData& frame, Random& random) {
  forSome(0.7, random,
          [&](int x, int y) { frame.radiance.at(x, y, random.integer(0, 2)) = brokenValue(random); });
}

void breakSurfaces(io::FrameData& frame, Random& random) {
  io::Image* const images[] = {&frame.normalWorld, &frame.positionWorld, &frame.albedo, &frame.emission};
  for (io::Image* image : images)
    forSome(0.2, random, [&](int x, int y) { image->at(x, y, random.integer(0, 2)) = brokenValue(random); });
}

void breakAll(io::FrameData& frame, Random& random) {
  for (float& value : frame.radiance.pixels) value = brokenValue(random);
}

// Halves beyond 65504 are infinite.
void breakHalves(io::FrameData& frame, Random& random) {
  breakRadiance(frame, random);
  addFireflies(frame, random);
}

void makeAllSky(io::FrameData& frame, Random&) {
  for (float& value : frame.normalWorld.pixels) value = 0.0f;
}

void addOddPixel(io::FrameData& frame, Random& random) {
  const int x = random.integer(0, kFaultEdge - 1), y = random.integer(0, kFaultEdge - 1);
  setPixel(frame.radiance, x, y, static_cast<float>(random.logUniform(1e-3, 1e3)));
  setPixel(frame.albedo, x, y, 1.0f);
  setPixel(frame.emission, x, y, 0.0f);
  for (int c = 0; c < 3; ++c) frame.normalWorld.at(x, y, c) *= -1.0f;
}

}  // namespace

const std::vector<FrameFamily>& frameFamilies() {
  static const std::vector<FrameFamily> all = {
      {"frames, fireflies", Trace::Fading, false, false, addFireflies},
      {"frames, denormal colors", Trace::Gone, true, false, addDenormals},
      {"frames, zero colors", Trace::Gone, true, false, addZeros},
      {"frames, negative colors", Trace::Gone, false, false, addNegatives},
      {"frames, broken colors", Trace::Gone, false, false, breakRadiance},
      {"frames, broken surfaces", Trace::Gone, false, false, breakSurfaces},
      {"frames, all broken", Trace::Gone, true, false, breakAll},
      {"frames, half inputs", Trace::Gone, false, true, breakHalves},
      {"frames, all sky", Trace::Gone, true, false, makeAllSky},
      {"frames, odd pixel", Trace::Fading, false, false, addOddPixel},
  };
  return all;
}

FrameRuns makeFrameRuns(const FrameFamily& family, std::uint32_t seed) {
  io::AnalyticOptions options;
  options.width = kFrameWidth;
  options.height = kFrameHeight;
  options.frameCount = kFramesInAll;
  options.seed = seed;
  const auto sequence = io::makeAnalyticSequence(options);
  Random random(seed);
  FrameRuns runs;
  for (const int number : sequence->frames()) {
    runs.clean.push_back(sequence->read(number));
    runs.faulty.push_back(runs.clean.back());
    if (number >= kFramesBefore && number < kFramesBefore + kFramesWithFault)
      family.makeFault(runs.faulty.back(), random);
  }
  return runs;
}

}  // namespace quell::stress
