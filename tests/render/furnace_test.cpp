// White furnace: under uniform light of radiance 1 a convex body sends back exactly its directional albedo.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/render/render_support.hpp"

namespace quell::tests {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr Size kSize{32, 32};

render::Scene sphereInFurnace(const render::Material& material) {
  render::Scene scene;
  scene.camera.eye = {0.0, -4.0, 0.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.camera.fieldOfViewDeg = 32.0;
  scene.sky = uniformSky(1.0);
  scene.sphere({{0.0, 0.0, 0.0}}, 1.0, scene.add(material));
  return scene;
}

/// Cosine between the normal and the direction to the camera.
double viewCosine(const render::Scene& scene, const render::Features& features, int x, int y) {
  const glm::dvec3 toViewer = glm::normalize(scene.camera.eye - pixel3(features.positionWorld, x, y));
  return glm::dot(toViewer, pixel3(features.normalWorld, x, y));
}

double masking(double cosine, double alpha) {
  const double a2 = alpha * alpha;
  return 2.0 * cosine / (cosine + std::sqrt(a2 + (1.0 - a2) * cosine * cosine));
}

/// Share of light from everywhere that GGX with separable Smith masking and Schlick's Fresnel sends to a
/// viewer: the integral over the half vector, d omega_i = 4 (o.h) d omega_h, by the midpoint rule.
/// Independent of the kernels' sampling; slope-space radius tan(theta) = alpha sqrt(u / (1 - u)) makes the
/// integrand smooth for every alpha.
double directionalAlbedo(double cosine, double alpha, double f0) {
  constexpr int kRadii = 160, kAngles = 48;
  const double sine = std::sqrt(1.0 - cosine * cosine);
  double sum = 0.0;
  for (int i = 0; i < kRadii; ++i) {
    const double u = (i + 0.5) / kRadii;
    const double tangent = alpha * std::sqrt(u / (1.0 - u));
    const double hz = 1.0 / std::sqrt(1.0 + tangent * tangent);
    const double hr = tangent * hz;
    for (int j = 0; j < kAngles; ++j) {
      const double phi = kPi * (j + 0.5) / kAngles;  // symmetric about the plane of view
      const double oh = sine * hr * std::cos(phi) + cosine * hz;
      const double iz = 2.0 * oh * hz - cosine;
      if (oh <= 0.0 || iz <= 0.0) continue;
      const double fresnel = f0 + (1.0 - f0) * std::pow(1.0 - oh, 5.0);
      // D cos(theta_h) d omega_h = du dphi / (2 pi), so the sum below is a mean.
      sum += fresnel * masking(cosine, alpha) * masking(iz, alpha) * oh / (cosine * hz);
    }
  }
  return sum / (kRadii * kAngles);
}

}  // namespace

TEST_CASE("a white diffuse sphere in uniform light is as bright as the light", "[render]") {
  const render::Scene scene = sphereInFurnace(render::matte(glm::dvec3(0.8)));
  render::PathTracer tracer = makeTracer(kSize);
  const render::Features features = tracer.features(scene, scene);
  const render::Light light = tracer.light(1, 16);
  int checked = 0;
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      if (features.objectId.at(x, y, 0) == 0.0f) continue;
      // Both techniques draw from the same density and hit the sky, so every single sample is exact.
      for (int c = 0; c < 3; ++c) REQUIRE(light.diffuse.at(x, y, c) == Approx(1.0).margin(2e-4));
      for (int c = 0; c < 3; ++c) REQUIRE(light.glossy.at(x, y, c) == 0.0f);
      ++checked;
    }
  CHECK(checked > 400);
}

TEST_CASE("GGX reflects its directional albedo and never more than it gets", "[render]") {
  const double f0 = GENERATE(1.0, 0.04);
  const double roughness = GENERATE(0.1, 0.35, 0.6, 1.0);
  CAPTURE(f0, roughness);
  const render::Scene scene = sphereInFurnace(render::metal(glm::dvec3(f0), roughness));
  render::PathTracer tracer = makeTracer(kSize);
  const render::Features features = tracer.features(scene, scene);
  const render::Light light = tracer.light(2, 512);
  // Pixels by cosine; noise averages out over a ring.
  constexpr int kRings = 6;
  std::vector<Statistics> difference(kRings);
  Statistics everywhere;
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      if (features.objectId.at(x, y, 0) == 0.0f) continue;
      const double cosine = viewCosine(scene, features, x, y);
      if (cosine < 0.1) continue;  // at grazing angles cosine itself is only known to a few percent
      const double expected = directionalAlbedo(cosine, roughness * roughness, f0);
      const double got = light.glossy.at(x, y, 0);
      difference[std::size_t(std::min(kRings - 1, int(cosine * kRings)))].add(got - expected);
      everywhere.add(got);
    }
  for (const Statistics& ring : difference) {
    if (ring.count < 20.0) continue;
    CHECK(std::abs(ring.mean()) < 4.5 * std::sqrt(ring.standardErrorSquared()) + 1e-3);
  }
  CHECK(everywhere.mean() < 1.0);
  CHECK(everywhere.mean() > (f0 == 1.0 ? 0.3 : 0.012));
}

TEST_CASE("the oracle of the furnace knows the limits", "[render]") {
  CHECK(directionalAlbedo(0.7, 1e-4, 1.0) == Approx(1.0).margin(1e-3));  // a mirror
  CHECK(directionalAlbedo(0.7, 1e-4, 0.04) == Approx(0.04 + 0.96 * std::pow(0.3, 5.0)).margin(1e-3));
  CHECK(directionalAlbedo(0.999, 1.0, 1.0) < 0.8);  // single scattering loses energy when rough
}

}  // namespace quell::tests
