#include "host/stress/color_blocks.hpp"

#include <limits>

#include "host/stress/feature_blocks.hpp"
#include "host/stress/signals.hpp"

namespace quell::stress {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kFirefly = 1e30;
constexpr Vector3 kSky{0.0, 0.0, 0.0};

std::size_t randomPixel(Random& random) {
  return static_cast<std::size_t>(random.integer(0, kBlockPixels - 1));
}

// Sets one component of this share of all pixels to NaN, Inf or -Inf.
void breakComponents(std::array<Vector3, kBlockPixels>& values, double share, Random& random) {
  constexpr double kBroken[] = {kNan, kInfinity, -kInfinity};
  for (Vector3& value : values)
    if (random.chance(share))
      value[static_cast<std::size_t>(random.integer(0, 2))] = kBroken[random.integer(0, 2)];
}

}  // namespace

void makeOddColor(Block& block, Random& random) {
  addRichSurface(block, View(random), random);
  block.radiance.fill({1.0, 0.5, 0.25});
  for (double& value : block.radiance[randomPixel(random)])
    value = random.chance(0.2) ? 0.0 : random.logUniform(1e-3, 1e5);
}

void makeFewValid(Block& block, Random& random) {
  constexpr void (*kSurfaces[])(Block&, Random&) = {makeDistant, makeNearlyAlignedPlane, makeSurfaceEdge,
                                                    makeNearlyDuplicatedFeatures};
  kSurfaces[random.integer(0, 3)](block, random);
  std::array<bool, kBlockPixels> valid{};
  const int count = random.integer(1, 12);
  for (int i = 0; i < count; ++i) valid[randomPixel(random)] = true;
  const bool othersAreSky = random.chance(0.5);
  for (std::size_t i = 0; i < valid.size(); ++i) {
    if (valid[i]) continue;
    if (othersAreSky) block.normalWorld[i] = kSky;
    if (!othersAreSky) block.radiance[i][1] = kNan;
  }
}

void makeFireflies(Block& block, Random& random) {
  makeRich(block, random);
  const int count = random.integer(1, kBlockPixels / 100);
  for (int i = 0; i < count; ++i)
    block.radiance[randomPixel(random)][static_cast<std::size_t>(random.integer(0, 2))] = kFirefly;
}

void makeDenormalColors(Block& block, Random& random) {
  makeRich(block, random);
  for (Vector3& radiance : block.radiance)
    for (double& value : radiance) value = random.uniform(0.0, 1e-38);
}

void makeZeroColors(Block& block, Random& random) { addRichSurface(block, View(random), random); }

void makeNegativeColors(Block& block, Random& random) {
  makeRich(block, random);
  const double share = random.uniform(0.01, 1.1);
  for (Vector3& radiance : block.radiance)
    for (double& value : radiance) value *= random.chance(share) ? -1.0 : 1.0;
}

void makeBrokenColors(Block& block, Random& random) {
  makeRich(block, random);
  breakComponents(block.radiance, random.uniform(0.01, 0.9), random);
}

void makeBrokenPositions(Block& block, Random& random) {
  makeRich(block, random);
  breakComponents(block.positionRelative, random.uniform(0.01, 0.9), random);
}

void makeAllBroken(Block& block, Random& random) {
  makeRich(block, random);
  breakComponents(block.radiance, 1.0, random);
}

void makeSky(Block& block, Random& random) { addLighting(block, random); }

}  // namespace quell::stress
