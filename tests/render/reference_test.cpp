// Frames of one sample average to the reference, halves are independent, and everything repeats.
#include <catch2/catch.hpp>
#include <cmath>

#include "host/render/scene_registry.hpp"
#include "tests/render/render_support.hpp"

namespace quell::tests {
namespace {

constexpr Size kSize{32, 18};
constexpr int kFrames = 200;
constexpr int kReferenceSamples = 1024;

}  // namespace

TEST_CASE("frames of one sample average to the reference", "[render]") {
  const std::string name = GENERATE("cornell", "roughness", "columns");
  CAPTURE(name);
  const render::Scene scene = render::makeScene(render::findScene(name), 0);
  render::PathTracer tracer = makeTracer(kSize);
  const render::Features features = tracer.features(scene, scene);
  const io::Image reference =
      render::composeColor(features, tracer.light(render::mixSeed(1, 0, 1), kReferenceSamples));

  std::vector<Statistics> pixels(reference.pixels.size());
  Statistics means;  // of whole frames
  for (int frame = 0; frame < kFrames; ++frame) {
    const io::Image color = render::composeColor(features, tracer.light(render::mixSeed(1, frame, 0), 1));
    double sum = 0.0;
    for (std::size_t i = 0; i < color.pixels.size(); ++i) {
      pixels[i].add(color.pixels[i]);
      sum += color.pixels[i];
    }
    means.add(sum / double(color.pixels.size()));
  }
  double referenceMean = 0.0, noise = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    referenceMean += reference.pixels[i];
    noise += pixels[i].variance();
  }
  const double count = double(pixels.size());
  referenceMean /= count;
  // The reference has the same noise, divided by its samples.
  const double referenceError2 = noise / count / kReferenceSamples / count;
  CAPTURE(means.mean(), referenceMean, std::sqrt(means.standardErrorSquared()));
  CHECK(std::abs(means.mean() - referenceMean) <
        4.0 * std::sqrt(means.standardErrorSquared() + referenceError2));
  CHECK(std::sqrt(means.standardErrorSquared()) < 0.02 * referenceMean);  // narrow enough to tell

  // Pixel by pixel: squared differences are what the variances say.
  double difference2 = 0.0, expected2 = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double difference = pixels[i].mean() - reference.pixels[i];
    difference2 += difference * difference;
    expected2 += pixels[i].variance() * (1.0 / kFrames + 1.0 / kReferenceSamples);
  }
  CHECK(difference2 == Approx(expected2).epsilon(0.25));
}

TEST_CASE("halves of a reference are independent, and seeds repeat", "[render]") {
  const render::Scene scene = render::makeScene(render::findScene("cornell"), 0);
  render::PathTracer tracer = makeTracer(kSize);
  tracer.features(scene, scene);
  const auto diffuse = [&](int stream, int samples) {
    return tracer.light(render::mixSeed(1, 0, stream), samples).diffuse.pixels;
  };
  const std::vector<float> a = diffuse(1, 64), b = diffuse(2, 64), truth = diffuse(3, 2048);
  CHECK(a == diffuse(1, 64));
  CHECK(a != b);
  double aa = 0.0, bb = 0.0, ab = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    aa += (a[i] - truth[i]) * (a[i] - truth[i]);
    bb += (b[i] - truth[i]) * (b[i] - truth[i]);
    ab += (a[i] - truth[i]) * (b[i] - truth[i]);
  }
  CHECK(std::abs(ab) < 0.15 * std::sqrt(aa * bb));  // 1 if they were equal; noise of the truth gives 0.03
  CHECK(aa == Approx(bb).epsilon(0.25));
}

TEST_CASE("samples are the same however they are batched", "[render]") {
  const render::Scene scene = render::makeScene(render::findScene("cornell"), 0);
  render::PathTracer tracer = makeTracer(kSize);
  tracer.features(scene, scene);
  int reported = 0;
  tracer.light(3, 21, render::Estimator::Both, [&](int samples) { reported += samples; });
  CHECK(reported == 21);
  CHECK(render::mixSeed(1, 0, 0) != render::mixSeed(1, 1, 0));
  CHECK(render::mixSeed(1, 0, 0) != render::mixSeed(1, 0, 1));
  CHECK(render::mixSeed(1, 0, 0) != render::mixSeed(2, 0, 0));
}

}  // namespace quell::tests
