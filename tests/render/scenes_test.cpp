// Every scene keeps the buffer contract and is what its name says.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "host/metrics/display_encoding.hpp"
#include "host/render/scene_registry.hpp"
#include "tests/render/render_support.hpp"

namespace quell::tests {
namespace {

constexpr Size kSize{48, 27};

struct Shot {
  render::Scene scene;
  render::Features features;
  render::Light light;
  io::Image color;
};

Shot shoot(render::PathTracer& tracer, const std::string& name, int frame, int samples = 1) {
  const render::SceneEntry& entry = render::findScene(name);
  Shot shot;
  shot.scene = render::makeScene(entry, frame);
  shot.features = tracer.features(shot.scene, render::makeScene(entry, frame - 1));
  shot.light = tracer.light(render::mixSeed(1, frame, 0), samples);
  shot.color = render::composeColor(shot.features, shot.light);
  return shot;
}

double meanOf(const io::Image& image) {
  double sum = 0.0;
  for (const float value : image.pixels) sum += value;
  return sum / double(image.pixels.size());
}

double backgroundShare(const Shot& shot) {
  const std::vector<float>& ids = shot.features.objectId.pixels;
  return double(std::count(ids.begin(), ids.end(), 0.0f)) / double(ids.size());
}

bool isInRange(const io::Image& image, float low, float high) {
  return std::all_of(image.pixels.begin(), image.pixels.end(),
                     [=](float value) { return value >= low && value <= high; });  // false for NaN
}

bool sameFeatures(const render::Features& a, const render::Features& b) {
  return a.positionWorld.pixels == b.positionWorld.pixels && a.normalWorld.pixels == b.normalWorld.pixels &&
         a.albedo.pixels == b.albedo.pixels && a.objectId.pixels == b.objectId.pixels;
}

void checkContract(const Shot& shot) {
  const render::Features& f = shot.features;
  CHECK(isInRange(f.albedo, 0.0f, 0.999f));
  CHECK(isInRange(f.glossColor, 0.0f, 1.0f));
  CHECK(isInRange(f.f0, 0.0f, 1.0f));
  CHECK(isInRange(f.roughness, 0.0f, 1.0f));
  CHECK(isInRange(f.emission, 0.0f, 65504.0f));
  CHECK(isInRange(f.motion, -200.0f, 200.0f));
  CHECK(isInRange(shot.light.diffuse, 0.0f, 1e6f));
  CHECK(isInRange(shot.light.glossy, 0.0f, 1e6f));
  CHECK(isInRange(shot.light.hitDistance, 0.0f, QUELL_MISS_DISTANCE));
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      const glm::dvec3 normal = pixel3(f.normalWorld, x, y), position = pixel3(f.positionWorld, x, y);
      if (f.objectId.at(x, y, 0) == 0.0f) {
        REQUIRE(normal == glm::dvec3(0.0));
        REQUIRE(position == glm::dvec3(0.0));
        REQUIRE(pixel3(shot.color, x, y) == pixel3(f.emission, x, y));
        continue;
      }
      REQUIRE(glm::length(normal) == Approx(1.0).margin(1e-4));
      REQUIRE(glm::dot(normal, shot.scene.camera.eye - position) > 0.0);
      if (f.emission.at(x, y, 0) > 0.0f) REQUIRE(pixel3(f.albedo, x, y) == glm::dvec3(0.0));
    }
}

}  // namespace

TEST_CASE("every scene keeps the buffer contract", "[render]") {
  render::PathTracer tracer = makeTracer(kSize);
  for (const render::SceneEntry& entry : render::scenes())
    for (const int frame : {0, 25}) {
      CAPTURE(entry.name, frame);
      const Shot shot = shoot(tracer, entry.name, frame);
      checkContract(shot);
      CHECK(shot.scene.objects().size() == render::makeScene(entry, 0).objects().size());
    }
}

TEST_CASE("every scene is exposed so that errors show", "[render]") {
  render::PathTracer tracer = makeTracer(kSize);
  for (const render::SceneEntry& entry : render::scenes()) {
    CAPTURE(entry.name);
    const double mean = meanOf(metrics::encodeForDisplay(shoot(tracer, entry.name, 0, 64).color));
    const bool dark = std::string(entry.name) == "dark";
    CHECK(mean > (dark ? 0.02 : 0.15));
    CHECK(mean < (dark ? 0.25 : 0.8));
  }
}

TEST_CASE("scenes are what their names say", "[render]") {
  render::PathTracer tracer = makeTracer(kSize);
  CHECK(backgroundShare(shoot(tracer, "open-sky", 0)) > 0.5);
  CHECK(backgroundShare(shoot(tracer, "cornell", 0)) == 0.0);
  CHECK(render::makeScene(render::findScene("foliage"), 0).objects().size() > 3000);

  const Shot rough = shoot(tracer, "roughness", 0);
  const auto [least, most] =
      std::minmax_element(rough.features.f0.pixels.begin(), rough.features.f0.pixels.end());
  CHECK(*least <= 0.04f);
  CHECK(*most >= 0.9f);
  std::vector<float> roughness = rough.features.roughness.pixels;
  std::sort(roughness.begin(), roughness.end());
  CHECK(roughness[roughness.size() / 10] < 0.25f);
  CHECK(roughness[roughness.size() * 9 / 10] > 0.45f);

  const Shot mirrors = shoot(tracer, "mirror", 0);
  int smooth = 0, glossy = 0;
  for (std::size_t i = 0; i < mirrors.features.roughness.pixels.size(); ++i) {
    if (mirrors.features.glossColor.pixels[3 * i] == 0.0f) continue;
    ++glossy;
    smooth += mirrors.features.roughness.pixels[i] <= 0.15f ? 1 : 0;
  }
  CHECK(glossy > 300);
  CHECK(smooth == glossy);
}

TEST_CASE("what stands still in a scene does", "[render]") {
  render::PathTracer tracer = makeTracer(kSize);
  const auto [first, second] = std::pair(shoot(tracer, "static", 3, 32), shoot(tracer, "static", 4, 32));
  CHECK(sameFeatures(first.features, second.features));
  CHECK(std::all_of(second.features.motion.pixels.begin(), second.features.motion.pixels.end(),
                    [](float value) { return value == 0.0f; }));
  CHECK(first.color.pixels != second.color.pixels);  // the noise is new
  CHECK(meanOf(first.color) == Approx(meanOf(second.color)).epsilon(0.1));

  const auto moving = [&](const std::string& name) {
    return !sameFeatures(shoot(tracer, name, 3).features, shoot(tracer, name, 4).features);
  };
  CHECK(moving("moving-objects"));
  CHECK(moving("roughness"));
  CHECK(moving("mirror"));
}

TEST_CASE("light-switch changes its light and nothing else at the switch", "[render]") {
  render::PathTracer tracer = makeTracer(kSize);
  const Shot before = shoot(tracer, "light-switch", render::kLightSwitchFrame - 1, 64);
  const Shot after = shoot(tracer, "light-switch", render::kLightSwitchFrame, 64);
  CHECK(before.features.normalWorld.pixels == after.features.normalWorld.pixels);
  CHECK(before.features.positionWorld.pixels == after.features.positionWorld.pixels);
  double change = 0.0;
  for (std::size_t i = 0; i < before.color.pixels.size(); ++i)
    change += std::abs(double(before.color.pixels[i]) - double(after.color.pixels[i]));
  CHECK(change / double(before.color.pixels.size()) > 0.3 * meanOf(before.color));
}

TEST_CASE("moving-light moves its light and nothing else", "[render]") {
  const render::Scene a = render::makeScene(render::findScene("moving-light"), 0);
  const render::Scene b = render::makeScene(render::findScene("moving-light"), 1);
  int moved = 0;
  for (std::size_t i = 0; i < a.objects().size(); ++i) {
    if (a.objects()[i].pose.position == b.objects()[i].pose.position) continue;
    ++moved;
    const auto& material = a.materials()[std::size_t(a.objects()[i].material)];
    CHECK(material.emission.x > 0.0);
  }
  CHECK(moved == 1);
  CHECK(a.camera.eye == b.camera.eye);
}

}  // namespace quell::tests
