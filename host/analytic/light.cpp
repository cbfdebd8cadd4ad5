#include "host/analytic/light.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/analytic/material.hpp"

namespace quell::io::analytic {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Towards the sun: through the open side, from the left, about 32 degrees high. Not of unit length.
constexpr glm::dvec3 kTowardsSun{-0.5, 0.78, 0.58};
// Radius of the sun's disc in rad, some four times the true one (0.0047), for shadow edges worth denoising.
constexpr double kSunRadiusRad = 0.02;
// Irradiance / pi of a surface that faces the sun.
constexpr glm::dvec3 kSunStrength{4.6, 3.9, 2.9};
// Stands for all light after the second surface, irradiance / pi.
constexpr glm::dvec3 kAmbient{0.16, 0.15, 0.14};

/// Two unit vectors that complete unit vector `n` to a right-handed frame (Duff et al. 2017, Listing 3).
void completeFrame(const glm::dvec3& n, glm::dvec3& tangent, glm::dvec3& bitangent) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  tangent = {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  bitangent = {b, sign + n.y * n.y * a, -n.y};
}

/// Uniform point on the unit disc.
glm::dvec2 samplePointOnDisc(Random& random) {
  const double radius = std::sqrt(random.uniform());
  const double angle = 2.0 * kPi * random.uniform();
  return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

/// Both vectors of the frame, weighted by the point on the disc.
glm::dvec3 acrossFrame(const glm::dvec3& axis, const glm::dvec2& onDisc) {
  glm::dvec3 tangent;
  glm::dvec3 bitangent;
  completeFrame(axis, tangent, bitangent);
  return onDisc.x * tangent + onDisc.y * bitangent;
}

bool leavesSurface(const Hit& hit, const glm::dvec3& direction) {
  return glm::dot(hit.normal, direction) > 0.0;
}

glm::dvec3 sampleLamp(const Hit& hit, const glm::dvec3& normal, Random& random) {
  const double x = glm::mix(kLampLow.x, kLampHigh.x, random.uniform());
  const double y = glm::mix(kLampLow.y, kLampHigh.y, random.uniform());
  const glm::dvec3 toLamp = glm::dvec3(x, y, kLampLow.z) - hit.position;
  const double distance = glm::length(toLamp);
  const glm::dvec3 direction = toLamp / distance;
  const double cosSurface = glm::dot(normal, direction);
  const double cosLamp = direction.z;  // the shining face looks straight down
  if (cosSurface <= 0.0 || cosLamp <= 0.0 || !leavesSurface(hit, direction)) return glm::dvec3(0.0);
  if (isOccluded({hit.position, direction}, distance)) return glm::dvec3(0.0);
  const double areaM2 = (kLampHigh.x - kLampLow.x) * (kLampHigh.y - kLampLow.y);
  return kLampRadiance * (cosSurface * cosLamp * areaM2 / (kPi * distance * distance));
}

glm::dvec3 sampleSun(const Hit& hit, const glm::dvec3& normal, Random& random) {
  const glm::dvec3 axis = glm::normalize(kTowardsSun);
  const glm::dvec3 direction =
      glm::normalize(axis + kSunRadiusRad * acrossFrame(axis, samplePointOnDisc(random)));
  const double cosSurface = glm::dot(normal, direction);
  if (cosSurface <= 0.0 || !leavesSurface(hit, direction)) return glm::dvec3(0.0);
  if (isOccluded({hit.position, direction}, std::numeric_limits<double>::infinity())) return glm::dvec3(0.0);
  return kSunStrength * cosSurface;
}

/// Irradiance / pi straight from a light. Each light is picked half of the time, hence counts twice.
glm::dvec3 sampleDirect(const Hit& hit, const glm::dvec3& normal, Random& random) {
  const bool pickLamp = random.uniform() < 0.5;
  return 2.0 * (pickLamp ? sampleLamp(hit, normal, random) : sampleSun(hit, normal, random));
}

/// Irradiance / pi from everything but the lights. With rays as dense as the cosine, it is the radiance met.
glm::dvec3 sampleIndirect(const Hit& hit, const glm::dvec3& normal, Random& random) {
  const glm::dvec2 onDisc = samplePointOnDisc(random);
  const double height = std::sqrt(std::max(0.0, 1.0 - glm::dot(onDisc, onDisc)));
  const glm::dvec3 direction = glm::normalize(acrossFrame(normal, onDisc) + height * normal);
  if (!leavesSurface(hit, direction)) return glm::dvec3(0.0);
  const auto next = nearestHit({hit.position, direction});
  if (!next) return skyRadiance(direction);
  // The lamp's own glow is left out here (its albedo is zero): sampleDirect has counted it.
  return albedoAt(*next) * (sampleDirect(*next, next->normal, random) + kAmbient);
}

std::uint64_t spreadBits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

}  // namespace

Random::Random(std::uint32_t seed, std::uint32_t stream, std::uint32_t frame, std::uint32_t pixel,
               std::uint32_t sample)
    : m_state(spreadBits((std::uint64_t(seed) << 32) + stream)) {
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15u;  // SplitMix64's increment
  m_state = spreadBits(m_state + kGolden + ((std::uint64_t(frame) << 32) | pixel));
  m_state = spreadBits(m_state + kGolden + sample);
}

double Random::uniform() {
  const std::uint64_t old = m_state;
  m_state = old * 6364136223846793005u + 1442695040888963407u;
  const auto mixed = std::uint32_t(((old >> 18) ^ old) >> 27);
  const auto turn = std::uint32_t(old >> 59);
  const std::uint32_t bits = (mixed >> turn) | (mixed << ((32u - turn) & 31u));
  return double(bits) / 4294967296.0;
}

glm::dvec3 sampleIrradiance(const Hit& hit, const glm::dvec3& shadingNormal, Random& random) {
  const glm::dvec3 direct = sampleDirect(hit, shadingNormal, random);
  return direct + sampleIndirect(hit, shadingNormal, random);
}

}  // namespace quell::io::analytic
