// Next-event estimation, secondary rays that hit the lights, and both combined have the same expectation.
#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/render/render_support.hpp"

namespace quell::tests {
namespace {

constexpr Size kSize{24, 16};
constexpr int kTile = 8;  // pixels; means over tiles are compared
constexpr int kBatches = 24;
constexpr int kSamplesPerBatch = 24;
// Of 6 tiles x 2 lobes x 2 pairs; 4.5 standard errors happen by chance once in 6000 runs. Seeds are fixed.
constexpr double kMostStandardErrors = 4.5;

/// A floor and a ball of diffuse and glossy material; lights are added by the caller.
render::Scene litScene() {
  render::Scene scene;
  scene.camera.eye = {0.0, -4.0, 2.0};
  scene.camera.target = {0.0, 0.0, 0.4};
  const int floor = scene.add(render::glazed({0.5, 0.4, 0.3}, 0.5));
  const int ball = scene.add(render::metal(render::kGold, 0.45));
  scene.rectangle({{0.0, 0.0, 0.0}}, 8.0, 8.0, floor);
  scene.sphere({{0.3, 0.0, 0.6}}, 0.6, ball);
  return scene;
}

render::Scene sceneWith(const std::string& kind) {
  render::Scene scene = litScene();
  if (kind == "rectangle")
    scene.rectangle({{0.5, -0.5, 3.0}, render::facing({0.0, 0.2, -1.0})}, 1.5, 1.0,
                    scene.add(render::emitter({3.0, 2.0, 1.0})));
  if (kind == "sphere") scene.sphere({{-0.8, -0.5, 2.4}}, 0.7, scene.add(render::emitter({3.0, 3.0, 3.0})));
  if (kind == "sky") scene.sky = uniformSky(0.7);
  if (kind == "sun") {
    scene.sky.sunDirection = {0.3, -0.4, 1.0};
    scene.sky.sunIrradiance = {2.0, 2.0, 2.0};
    scene.sky.sunRadiusDeg = 15.0;  // secondary rays hardly find a smaller one
  }
  if (kind == "all") {
    scene = sceneWith("rectangle");
    scene.sphere({{-1.6, 0.5, 1.4}}, 0.5, scene.add(render::emitter({2.0, 3.0, 4.0})));
    scene.sky = uniformSky(0.3);
  }
  return scene;
}

/// Statistics over batches of the mean of each tile, diffuse and glossy in turn.
std::vector<Statistics> tileStatistics(render::PathTracer& tracer, render::Estimator estimator) {
  const int tilesX = kSize.width / kTile, tilesY = kSize.height / kTile;
  std::vector<Statistics> statistics(std::size_t(2 * tilesX * tilesY));
  for (int batch = 0; batch < kBatches; ++batch) {
    const std::uint32_t seed = render::mixSeed(5, batch, int(estimator));
    const render::Light light = tracer.light(seed, kSamplesPerBatch, estimator);
    std::size_t index = 0;
    for (const io::Image* image : {&light.diffuse, &light.glossy})
      for (int tileY = 0; tileY < tilesY; ++tileY)
        for (int tileX = 0; tileX < tilesX; ++tileX) {
          double sum = 0.0;
          for (int y = 0; y < kTile; ++y)
            for (int x = 0; x < kTile; ++x) sum += image->at(kTile * tileX + x, kTile * tileY + y, 0);
          statistics[index++].add(sum / (kTile * kTile));
        }
  }
  return statistics;
}

}  // namespace

TEST_CASE("estimates by light sampling, by BSDF sampling and by both agree", "[render]") {
  const std::string kind = GENERATE("rectangle", "sphere", "sky", "sun", "all");
  const render::Scene scene = sceneWith(kind);
  render::PathTracer tracer = makeTracer(kSize);
  tracer.features(scene, scene);
  const auto both = tileStatistics(tracer, render::Estimator::Both);
  const auto lights = tileStatistics(tracer, render::Estimator::LightOnly);
  const auto bsdf = tileStatistics(tracer, render::Estimator::BsdfOnly);
  double lit = 0.0;
  for (std::size_t i = 0; i < both.size(); ++i) {
    CAPTURE(kind, i, both[i].mean(), lights[i].mean(), bsdf[i].mean());
    CHECK(standardErrors(both[i], lights[i]) < kMostStandardErrors);
    CHECK(standardErrors(both[i], bsdf[i]) < kMostStandardErrors);
    // The test can tell a wrong factor: the error bars are narrow.
    if (both[i].mean() > 0.02) CHECK(std::sqrt(both[i].standardErrorSquared()) < 0.05 * both[i].mean());
    lit += both[i].mean();
  }
  CHECK(lit > 0.1);
}

TEST_CASE("both estimates together are less noisy than the worse one", "[render]") {
  const render::Scene scene = sceneWith("rectangle");
  render::PathTracer tracer = makeTracer(kSize);
  tracer.features(scene, scene);
  const auto variance = [&](render::Estimator estimator) {
    double sum = 0.0;
    for (const Statistics& tile : tileStatistics(tracer, estimator)) sum += tile.variance();
    return sum;
  };
  const double both = variance(render::Estimator::Both);
  CHECK(both < variance(render::Estimator::BsdfOnly));
  CHECK(both < variance(render::Estimator::LightOnly));
}

}  // namespace quell::tests
