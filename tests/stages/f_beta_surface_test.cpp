// F_beta of surfaces: from geometry and material, in division and multiplication, and with broken inputs.
#include <Eigen/Core>
#include <array>

#include "tests/stages/f_beta_probe.hpp"
#include "tests/support/random_images.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

constexpr std::size_t kSurfaces = 1024, kSurfacePlanes = 16, kResultPlanes = 6;

Eigen::Vector3d randomDirection(Random& random) {
  Eigen::Vector3d direction;
  do direction = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
  while (direction.norm() > 1.0 || direction.norm() < 0.1);
  return direction.normalized();
}

// Planes of the kernel `surface`: camera-relative positions of any size, unit normals, F0 and gloss colour in [0, 1],
// signals up to 316.
std::vector<float> randomSurfaces() {
  Random random(21);
  std::vector<float> planes(kSurfaces * kSurfacePlanes);
  const auto at = [&](std::size_t plane, std::size_t i) -> float& { return planes[plane * kSurfaces + i]; };
  for (std::size_t i = 0; i < kSurfaces; ++i) {
    const double distance = std::pow(10.0, random.uniform(-6.0, 15.0));
    const Eigen::Vector3d normal = randomDirection(random), position = distance * randomDirection(random);
    for (std::size_t c = 0; c < 3; ++c) {
      at(c, i) = float(position[Eigen::Index(c)]);
      at(3 + c, i) = float(normal[Eigen::Index(c)]);
      at(6 + c, i) = float(random.uniform());
      at(9 + c, i) = float(random.uniform());
      at(12 + c, i) = float(std::pow(10.0, random.uniform(-3.0, 2.5)));
    }
    at(15, i) = float(random.uniform());
  }
  return planes;
}

Eigen::Vector3d vectorAt(const std::vector<float>& planes, std::size_t plane, std::size_t i) {
  return {planes[plane * kSurfaces + i], planes[(plane + 1) * kSurfaces + i],
          planes[(plane + 2) * kSurfaces + i]};
}

}  // namespace

TEST_CASE("F_beta of a surface follows from position, normal, roughness and F0") {
  const std::vector<float> in = randomSurfaces();
  for (const Mapping mapping : kProbedMappings) {
    const std::vector<float> out =
        Probe(mapping, Shadowing::Separable).run("surface", in, kSurfacePlanes, kResultPlanes);
    double largest = 0.0;
    for (std::size_t i = 0; i < kSurfaces; ++i) {
      const double cosTheta = absCosine(vectorAt(in, 0, i), vectorAt(in, 3, i));
      const FBetaTerms exact = exactFBeta(cosTheta, in[15 * kSurfaces + i], Shadowing::Separable);
      for (std::size_t c = 0; c < 3; ++c) {
        const double value = out[c * kSurfaces + i];
        REQUIRE(std::isfinite(value));
        const double error = std::abs(value - exact.scale * in[(6 + c) * kSurfaces + i] - exact.bias);
        if (cosTheta >= kUsualFrom) largest = std::max(largest, error);
      }
    }
    INFO("largest error " << largest);
    CHECK(largest < 4e-4);  // those of scale and bias may add up
  }
}

TEST_CASE(
    "a signal divided by gloss colour times F_beta and multiplied again is the same to half precision") {
  constexpr double kHalfUlp = 1.0 / 2048;  // of half precision, relative
  const std::vector<float> in = randomSurfaces();
  for (const Mapping mapping : kProbedMappings) {
    const std::vector<float> out =
        Probe(mapping, Shadowing::HeightCorrelated).run("surface", in, kSurfacePlanes, kResultPlanes);
    double largest = 0.0;
    for (std::size_t i = 0; i < kSurfaces; ++i) {
      const Eigen::Vector3d signal = vectorAt(in, 12, i), back = vectorAt(out, 3, i);
      largest = std::max(largest, ((back - signal).cwiseQuotient(signal)).cwiseAbs().maxCoeff());
    }
    INFO("largest relative change " << largest);
    CHECK(largest <= kHalfUlp);
  }
}

TEST_CASE("F_beta of a broken surface is finite") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  std::vector<float> in = randomSurfaces();
  Random random(22);
  for (const std::size_t plane : {0, 1, 2, 3, 4, 5, 15})
    for (std::size_t i = 0; i < kSurfaces; ++i)
      if (const int what = random.integer(0, 15); what < 5)
        in[plane * kSurfaces + i] = std::array<float, 5>{nan, inf, -inf, 0.0f, 3e38f}[std::size_t(what)];
  for (std::size_t i = 0; i < kSurfaces; i += 7)  // positions at the camera, normals of the background
    for (std::size_t plane = 0; plane < 6; ++plane) in[plane * kSurfaces + i] = 0.0f;
  for (const Mapping mapping : kProbedMappings) {
    const std::vector<float> out =
        Probe(mapping, Shadowing::Separable).run("surface", in, kSurfacePlanes, kResultPlanes);
    for (std::size_t i = 0; i < 3 * kSurfaces; ++i) {
      REQUIRE(out[i] >= 0.0f);
      REQUIRE(out[i] <= 1.0f + 1e-5f);
    }
  }
}
