#include "host/analytic/material.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace quell::io::analytic {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Colours below are linear albedos picked by eye, well inside what real paint, wood and stone reflect.
// Sizes of the patterns in m, chosen to stay above one pixel (about 7 mm at 5 m) at 1280x720.
constexpr double kPlankWidthM = 0.22;
constexpr double kPlankLengthM = 1.9;
constexpr double kPlankGapM = 0.012;
constexpr double kGrainWidthM = 0.035;
constexpr double kGrainLengthM = 0.6;
constexpr double kBrickLengthM = 0.46;
constexpr double kBrickHeightM = 0.17;
constexpr double kMortarM = 0.024;
constexpr double kBrickRoundingM = 0.05;  // width of the rounded rim, mortar included
constexpr double kBrickRimTilt = 0.9;     // steepest slope of the rim, rise over run
constexpr double kBrickRoughTilt = 0.12;  // slope of the face's unevenness, rise over run
constexpr double kBrickRoughM = 0.11;     // its wavelength
constexpr double kStripeM = 0.3;
constexpr double kPanellingHeightM = 0.95;  // lower part of the striped wall
constexpr double kPanelLengthM = 0.9;
constexpr double kPanelFrameM = 0.11;
constexpr double kRugTileM = 0.25;
constexpr double kSandSpotLengthM = 0.11;
constexpr double kSandSpotHeightM = 0.07;

/// Repeatable value in [0, 1) for a cell of a pattern (finaliser of MurmurHash3, Appleby, public domain).
double cellValue(int i, int j) {
  std::uint32_t h = std::uint32_t(i) * 0x9E3779B1u + std::uint32_t(j) * 0x85EBCA77u;
  h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 13)) * 0xC2B2AE35u;
  return double(h ^ (h >> 16)) / 4294967296.0;
}

/// Smooth value noise over the plane, in [0, 1), one cell per unit.
double smoothNoise(double x, double y) {
  const int i = int(std::floor(x));
  const int j = int(std::floor(y));
  const glm::dvec2 t = glm::smoothstep(0.0, 1.0, glm::dvec2(x - i, y - j));
  const double low = glm::mix(cellValue(i, j), cellValue(i + 1, j), t.x);
  const double high = glm::mix(cellValue(i, j + 1), cellValue(i + 1, j + 1), t.x);
  return glm::mix(low, high, t.y);
}

glm::dvec3 woodFloor(double across, double along) {
  const double plank = std::floor(across / kPlankWidthM);
  const double shifted = along / kPlankLengthM + cellValue(int(plank), 7);
  const double piece = std::floor(shifted);
  const double acrossM = across - plank * kPlankWidthM;
  const double alongM = (shifted - piece) * kPlankLengthM;
  if (std::min(acrossM, alongM) < kPlankGapM) return {0.10, 0.055, 0.03};
  const double tint = cellValue(int(plank), int(piece) + 100);
  const double grain = smoothNoise(across / kGrainWidthM, along / kGrainLengthM + 10.0 * tint);
  return glm::mix(glm::dvec3(0.36, 0.20, 0.10), glm::dvec3(0.62, 0.41, 0.23), 0.55 * tint + 0.45 * grain);
}

glm::dvec3 darkWood(double across, double along) {
  const double grain = smoothNoise(across / kGrainWidthM, along / kGrainLengthM);
  return glm::mix(glm::dvec3(0.16, 0.085, 0.045), glm::dvec3(0.28, 0.16, 0.085), grain);
}

/// Where a point lies on its brick: cell numbers, and distance to the brick's middle in m along y and z.
struct BrickPlace {
  int column;
  int row;
  glm::dvec2 fromMiddle;
};

BrickPlace brickPlace(double y, double z) {
  const double row = std::floor(z / kBrickHeightM);
  const double shifted = y / kBrickLengthM + 0.5 * std::fmod(row, 2.0);  // a half brick every second row
  const double column = std::floor(shifted);
  return {int(column), int(row), {(shifted - column - 0.5) * kBrickLengthM, z - (row + 0.5) * kBrickHeightM}};
}

glm::dvec3 bricks(double y, double z) {
  const BrickPlace place = brickPlace(y, z);
  const glm::dvec2 toRim = glm::dvec2(kBrickLengthM, kBrickHeightM) * 0.5 - glm::abs(place.fromMiddle);
  if (std::min(toRim.x, toRim.y) < 0.5 * kMortarM) return {0.58, 0.54, 0.48};
  const double tint = cellValue(place.column, place.row);
  return glm::mix(glm::dvec3(0.42, 0.15, 0.09), glm::dvec3(0.66, 0.34, 0.22), tint);
}

/// Slope of one rounded side of a brick at `fromMiddle` of a brick `size` long: zero on the flat face.
double rimSlope(double fromMiddle, double size) {
  const double intoRim = kBrickRoundingM - (0.5 * size - std::abs(fromMiddle));
  if (intoRim <= 0.0) return 0.0;
  return std::copysign(kBrickRimTilt * std::sin(kPi * intoRim / kBrickRoundingM), fromMiddle);
}

glm::dvec3 stripedWall(double y, double z) {
  if (z < kPanellingHeightM) {
    const double fromMiddle = std::abs(glm::fract(y / kPanelLengthM) - 0.5) * kPanelLengthM;
    const double toFrame = std::min(0.5 * (kPanelLengthM - kPanelFrameM) - fromMiddle,
                                    std::min(z, kPanellingHeightM - z) - kPanelFrameM);
    const bool isFrame = toFrame < 0.0;
    return isFrame ? glm::dvec3(0.13, 0.24, 0.23) : glm::dvec3(0.17, 0.31, 0.29);
  }
  const bool isLight = glm::fract(y / kStripeM) < 0.5;
  return isLight ? glm::dvec3(0.80, 0.76, 0.66) : glm::dvec3(0.50, 0.62, 0.58);
}

glm::dvec3 sandstone(const glm::dvec3& p) {
  const double spots = smoothNoise((p.x + p.y) / kSandSpotLengthM, p.z / kSandSpotHeightM);
  return glm::mix(glm::dvec3(0.60, 0.52, 0.41), glm::dvec3(0.74, 0.67, 0.55), spots);
}

glm::dvec3 rug(double x, double y) {
  const int i = int(std::floor(x / kRugTileM));
  const int j = int(std::floor(y / kRugTileM));
  return (i + j) % 2 == 0 ? glm::dvec3(0.70, 0.66, 0.58) : glm::dvec3(0.12, 0.17, 0.30);
}

/// Waves bent by slower waves; all factors are in rad per m or rad, picked by eye.
glm::dvec3 marble(const glm::dvec3& p) {
  const double swirl = 2.5 * std::sin(3.1 * p.y + 2.0 * p.x) + 1.5 * std::sin(5.3 * p.x - 4.0 * p.z);
  const double vein = 0.5 + 0.5 * std::sin(9.0 * p.z + 4.0 * p.x + swirl);
  return glm::mix(glm::dvec3(0.82, 0.80, 0.76), glm::dvec3(0.20, 0.34, 0.27), vein * vein * vein);
}

bool isShining(const Hit& hit) { return hit.surface == Surface::Lamp && hit.normal.z < 0.0; }

}  // namespace

glm::dvec3 albedoAt(const Hit& hit) {
  const glm::dvec3& p = hit.position;
  switch (hit.surface) {
    case Surface::WoodFloor:
      return woodFloor(p.x, p.y);
    case Surface::BeamWood:
      return darkWood(p.y + p.z, p.x);
    case Surface::BenchWood:
      return darkWood(p.x + p.z, p.y);
    case Surface::Bricks:
      return bricks(p.y, p.z);
    case Surface::StripedWall:
      return stripedWall(p.y, p.z);
    case Surface::Plaster:
      return {0.78, 0.76, 0.72};
    case Surface::Sandstone:
      return sandstone(p);
    case Surface::Rug:
      return rug(p.x, p.y);
    case Surface::Marble:
      return marble(p);
    case Surface::RedPaint:
      return {0.68, 0.09, 0.06};
    case Surface::BluePaint:
      return {0.07, 0.22, 0.62};
    case Surface::OchrePaint:
      return {0.78, 0.52, 0.12};
    case Surface::Lamp:
      return isShining(hit) ? glm::dvec3(0.0) : glm::dvec3(0.25);
  }
  return glm::dvec3(0.0);
}

glm::dvec3 emissionAt(const Hit& hit) { return isShining(hit) ? kLampRadiance : glm::dvec3(0.0); }

glm::dvec3 shadingNormalAt(const Hit& hit, const glm::dvec3& viewDirection) {
  if (hit.surface != Surface::Bricks) return hit.normal;
  const glm::dvec3& p = hit.position;
  const glm::dvec2 fromMiddle = brickPlace(p.y, p.z).fromMiddle;
  const double wave = 2.0 * kPi / kBrickRoughM;
  const double slopeY =
      rimSlope(fromMiddle.x, kBrickLengthM) + kBrickRoughTilt * std::sin(wave * p.y) * std::cos(wave * p.z);
  const double slopeZ = rimSlope(fromMiddle.y, kBrickHeightM) +
                        kBrickRoughTilt * std::cos(0.7 * wave * p.y) * std::sin(0.9 * wave * p.z);
  const glm::dvec3 bumped = glm::normalize(hit.normal + glm::dvec3(0.0, slopeY, slopeZ));
  // Seen at a grazing angle, a slope can turn away from the viewer, which no visible point does.
  return glm::dot(bumped, viewDirection) < 0.0 ? bumped : hit.normal;
}

glm::dvec3 skyRadiance(const glm::dvec3& direction) {
  constexpr glm::dvec3 kHorizon{1.35, 1.22, 1.08};
  constexpr glm::dvec3 kZenith{0.30, 0.58, 1.10};
  constexpr glm::dvec3 kSeaFar{0.42, 0.62, 0.74};
  constexpr glm::dvec3 kSeaNear{0.05, 0.20, 0.28};
  constexpr double kHazeElevation = 0.22;  // sine of the elevation where haze falls to 1/e
  constexpr double kSeaFade = 0.12;        // sine of the depression where the far colour falls to 1/e
  if (direction.z < 0.0) return glm::mix(kSeaNear, kSeaFar, std::exp(direction.z / kSeaFade));
  return glm::mix(kZenith, kHorizon, std::exp(-direction.z / kHazeElevation));
}

}  // namespace quell::io::analytic
