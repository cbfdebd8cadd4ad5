#include "host/stress/feature_blocks.hpp"

#include <cmath>

#include "host/stress/geometry.hpp"
#include "host/stress/signals.hpp"

namespace quell::stress {
namespace {

// Least cosine between a plane's normal and the view axis.
constexpr double kLeastCosine = 0.5;
// Least component of an oblique plane's normal.
constexpr double kLeastComponent = 0.5;

double randomDistance(Random& random) { return random.logUniform(0.5, 50.0); }

// A surface without a normal map, waves of 10 to 25 % of the block's extent.
void addWaves(Block& block, const View& view, double distance, Random& random) {
  addWavySurface(block, view, distance, random.uniform(0.1, 0.25), random);
}

Vector3 obliqueNormal(const View& view, Random& random) {
  for (;;) {
    const Vector3 normal = randomDirection(random);
    bool fits = std::abs(dot(normal, view.forward())) > kLeastCosine;
    for (const double component : normal) fits = fits && std::abs(component) > kLeastComponent;
    if (fits) return normal;
  }
}

// The axis that the camera looks along most.
std::size_t facingAxis(const View& view) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(view.forward()[i]) > std::abs(view.forward()[longest])) longest = i;
  return longest;
}

Vector3 facingDirection(const View& view) {
  Vector3 direction{};
  direction[facingAxis(view)] = 1.0;
  return direction;
}

void makeEdge(Block& block, double distanceRatio, Random& random) {
  const View view(random);
  const double distance = randomDistance(random);
  Block other;
  addWaves(block, view, distance, random);
  addWaves(other, view, distance * distanceRatio, random);
  other.normalWorld.fill(randomDirection(random));
  addGentleLighting(block, random);
  addGentleLighting(other, random);
  cutByEdge(block, other, random);
}

// Low waves with a fine normal map: smooth light over it is close to what features can follow.
void addCalmSurface(Block& block, const View& view, Random& random) {
  addWavySurface(block, view, randomDistance(random), random.uniform(0.03, 0.1), random);
  roughenNormals(block, random.uniform(0.1, 0.3), random);
}

// The position's coordinate along the view repeats another one, up to this difference, and so does one of the
// normal's across it. What tells the block's pixels apart stays.
void duplicateColumns(Block& block, const View& view, double difference, Random& random) {
  const std::size_t along = facingAxis(view);
  const std::size_t across = (along + 1) % 3;
  const std::size_t other = (along + 2) % 3;
  for (int i = 0; i < kBlockPixels; ++i) {
    Vector3& position = block.positionRelative[i];
    Vector3& normal = block.normalWorld[i];
    position[along] = position[across] * (1.0 + difference * random.uniform(-1.0, 1.0));
    normal[other] = normal[across] * (1.0 + difference * random.uniform(-1.0, 1.0));
  }
}

}  // namespace

void addRichSurface(Block& block, const View& view, Random& random) {
  const double distance = randomDistance(random);
  addWaves(block, view, distance, random);
  roughenPositions(block, view, distance, random.uniform(0.2, 0.5), random);
  roughenNormals(block, random.uniform(0.4, 0.8), random);
}

void makeRich(Block& block, Random& random) {
  addRichSurface(block, View(random), random);
  addLighting(block, random);
}

void makeConstantNormals(Block& block, Random& random) {
  addWaves(block, View(random), randomDistance(random), random);
  block.normalWorld.fill(randomDirection(random));
  addLighting(block, random);
}

void makeAlignedPlane(Block& block, Random& random) {
  const View view(random);
  addPlane(block, view, facingDirection(view), randomDistance(random));
  addLighting(block, random);
}

void makeObliquePlane(Block& block, Random& random) {
  const View view(random);
  addPlane(block, view, obliqueNormal(view, random), randomDistance(random));
  addLighting(block, random);
}

void makeNearlyAlignedPlane(Block& block, Random& random) {
  const View view(random);
  const Vector3 tilt = scale(randomDirection(random), random.logUniform(1e-7, 1e-2));
  addPlane(block, view, normalized(add(facingDirection(view), tilt)), randomDistance(random));
  addGentleLighting(block, random);
}

void makeConstantFeatures(Block& block, Random& random) {
  block.positionRelative.fill(scale(randomDirection(random), randomDistance(random)));
  block.normalWorld.fill(randomDirection(random));
  addLighting(block, random);
}

void makeNearlyConstantFeatures(Block& block, Random& random) {
  const double distance = randomDistance(random);
  const double range = distance * random.logUniform(1e-8, 1e-3);
  const Vector3 centre = scale(randomDirection(random), distance);
  for (Vector3& position : block.positionRelative)
    position = add(centre, scale(randomDirection(random), range));
  block.normalWorld.fill(randomDirection(random));
  roughenNormals(block, random.logUniform(1e-8, 1e-3), random);
  addGentleLighting(block, random);
}

void makeDuplicatedFeatures(Block& block, Random& random) {
  const View view(random);
  addRichSurface(block, view, random);
  duplicateColumns(block, view, 0.0, random);
  addLighting(block, random);
}

void makeNearlyDuplicatedFeatures(Block& block, Random& random) {
  const View view(random);
  if (random.chance(0.5)) {
    addSphere(block, view, randomDistance(random), random);
    roughenNormals(block, random.logUniform(1e-7, 1e-2), random);
  } else {
    addCalmSurface(block, view, random);
    duplicateColumns(block, view, random.logUniform(1e-7, 1e-2), random);
  }
  addGentleLighting(block, random);
}

void makeSurfaceEdge(Block& block, Random& random) { makeEdge(block, random.logUniform(1.01, 1e4), random); }

void makeSkyEdge(Block& block, Random& random) {
  makeRich(block, random);
  cutByEdge(block, Block{}, random);
}

void makeDistant(Block& block, Random& random) {
  addCalmSurface(block, View(random), random);
  addGentleLighting(block, random);
  offsetPositions(block, scale(randomDirection(random), random.logUniform(1e2, 1e7)));
}

void makeVeryDistant(Block& block, Random& random) {
  addCalmSurface(block, View(random), random);
  addGentleLighting(block, random);
  const double distance = random.logUniform(1e8, 1e17);
  const double share = random.logUniform(1e-6, 1e-3);
  for (Vector3& position : block.positionRelative) position = scale(position, share * distance);
  offsetPositions(block, scale(randomDirection(random), distance));
}

void makeOddFeatures(Block& block, Random& random) {
  makeConstantFeatures(block, random);
  const auto odd = static_cast<std::size_t>(random.integer(0, kBlockPixels - 1));
  const int kind = random.integer(0, 2);
  if (kind != 0) block.normalWorld[odd] = randomDirection(random);
  Vector3& position = block.positionRelative[odd];
  if (kind != 1) position = add(position, scale(randomDirection(random), random.logUniform(1e-6, 1e6)));
}

}  // namespace quell::stress
