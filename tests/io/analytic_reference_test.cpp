// The noise of the built-in sequence averages to its references.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "host/analytic/sequence.hpp"

using quell::io::AnalyticOptions;
using quell::io::FrameData;
using quell::io::FrameSequence;
using quell::io::Image;
using quell::io::makeAnalyticSequence;
using quell::io::Reference;
using quell::io::ReferenceKind;

namespace {

AnalyticOptions optionsOfSize(int width, int height) {
  AnalyticOptions options;
  options.width = width;
  options.height = height;
  return options;
}

// Radiance of sky and lamp is the same in each frame but for the rounding of the sums.
constexpr double kNoiseFreeVariance = 1e-9;

/// Mean and variance of each value over all frames.
struct Moments {
  std::vector<double> mean;
  std::vector<double> variance;
};

Moments momentsOfRadiance(const FrameSequence& sequence, std::size_t valueCount) {
  Moments moments{std::vector<double>(valueCount, 0.0), std::vector<double>(valueCount, 0.0)};
  const std::vector<int> frames = sequence.frames();
  for (const int frame : frames) {
    const FrameData data = sequence.read(frame);
    for (std::size_t i = 0; i < valueCount; ++i) {
      const double value = data.radiance.pixels[i];
      moments.mean[i] += value / double(frames.size());
      moments.variance[i] += value * value / double(frames.size());  // about zero, for now
    }
  }
  for (std::size_t i = 0; i < valueCount; ++i) moments.variance[i] -= moments.mean[i] * moments.mean[i];
  return moments;
}

}  // namespace

TEST_CASE("analytic sequence: the noise averages to the reference", "[io]") {
  // Many frames of few pixels: where rare bright paths make the noise, fewer do not show its variance.
  constexpr int kFrames = 8192;
  AnalyticOptions options = optionsOfSize(12, 8);
  options.threadCount = 1;  // frames this small are done before a second thread has started
  options.movingCamera = false;
  options.frameCount = kFrames;
  options.referenceSamples = kFrames;
  const auto sequence = makeAnalyticSequence(options);
  const Reference reference = sequence->reference(0, ReferenceKind::Centre);
  REQUIRE(reference.a.pixels != reference.b.pixels);

  const Moments noisy = momentsOfRadiance(*sequence, reference.a.pixels.size());
  double sumOfNormalised = 0.0;
  int noisyValues = 0;
  for (std::size_t i = 0; i < noisy.mean.size(); ++i) {
    const double expected = 0.5 * (double(reference.a.pixels[i]) + double(reference.b.pixels[i]));
    INFO("value " << i << ": mean " << noisy.mean[i] << ", reference " << expected << ", variance "
                  << noisy.variance[i]);
    if (noisy.variance[i] < kNoiseFreeVariance) {
      REQUIRE(noisy.mean[i] == Approx(expected).epsilon(1e-6));
      continue;
    }
    const double standardError =
        std::sqrt(noisy.variance[i] * (1.0 / kFrames + 0.5 / options.referenceSamples));
    // Chance of one wrong alarm among 288 normal values: 2e-4 at 5 standard errors.
    REQUIRE(std::abs(noisy.mean[i] - expected) < 5.0 * standardError);
    sumOfNormalised += (noisy.mean[i] - expected) / standardError;
    ++noisyValues;
  }
  REQUIRE(noisyValues > 200);
  // The three channels of a pixel move together, so there are a third as many independent values.
  REQUIRE(std::abs(sumOfNormalised / noisyValues) < 4.0 / std::sqrt(noisyValues / 3.0));
}

TEST_CASE("analytic sequence: the antialiased reference is the mean over the pixel", "[io]") {
  AnalyticOptions options = optionsOfSize(32, 18);
  options.movingCamera = false;
  options.referenceSamples = 256;
  const auto sequence = makeAnalyticSequence(options);
  const Reference centre = sequence->reference(0, ReferenceKind::Centre);
  const Reference antialiased = sequence->reference(0, ReferenceKind::Antialiased);
  options.jitter = true;
  options.frameCount = 256;
  const std::vector<double> sampled =
      momentsOfRadiance(*makeAnalyticSequence(options), centre.a.pixels.size()).mean;
  const auto differenceFrom = [&](const Image& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < sampled.size(); ++i) sum += std::pow(sampled[i] - double(image.pixels[i]), 2);
    return std::sqrt(sum / double(sampled.size()));
  };
  REQUIRE(antialiased.a.pixels != antialiased.b.pixels);
  REQUIRE(differenceFrom(antialiased.a) < 0.5 * differenceFrom(centre.a));
}

TEST_CASE("analytic sequence: no reference unless asked for", "[io]") {
  REQUIRE_FALSE(makeAnalyticSequence(optionsOfSize(8, 8))->hasReference(0, ReferenceKind::Centre));
}
