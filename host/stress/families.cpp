#include "host/stress/families.hpp"

#include "host/core/fnv1a.hpp"
#include "host/stress/color_blocks.hpp"
#include "host/stress/feature_blocks.hpp"
#include "host/stress/geometry.hpp"

namespace quell::stress {
namespace {

// The whole scene lies far from the world's origin, the camera within it.
void offsetCamera(Batch& batch, Random& random) {
  batch.cameraWorld = scale(randomDirection(random), random.logUniform(1e2, 1e7));
}

void scaleScene(Batch& batch, Random& random) { batch.unit = random.logUniform(1e-6, 1e6); }

void offsetAndScale(Batch& batch, Random& random) {
  offsetCamera(batch, random);
  scaleScene(batch, random);
}

void storeAsHalf(Batch& batch, Random&) { batch.halfInputs = true; }

}  // namespace

const std::vector<Family>& families() {
  constexpr Posedness well = Posedness::Well;
  constexpr Posedness ill = Posedness::Ill;
  static const std::vector<Family> table = {
      {"independent features", well, makeRich},
      {"constant normals", well, makeConstantNormals},
      {"planes, axis-aligned", well, makeAlignedPlane},
      {"planes, oblique", well, makeObliquePlane},
      {"planes, nearly aligned", ill, makeNearlyAlignedPlane},
      {"all features constant", well, makeConstantFeatures},
      {"all features nearly constant", ill, makeNearlyConstantFeatures},
      {"features duplicated", well, makeDuplicatedFeatures},
      {"features nearly duplicated", ill, makeNearlyDuplicatedFeatures},
      {"cut by an edge, surfaces", ill, makeSurfaceEdge},
      {"cut by an edge, sky", well, makeSkyEdge},
      {"world offset 1e2..1e7", well, makeRich, offsetCamera},
      {"camera distance 1e2..1e7", ill, makeDistant},
      {"camera distance 1e8..1e17", ill, makeVeryDistant},
      {"positions scaled 1e-6..1e6", well, makeRich, scaleScene},
      {"offset, distant and scaled", ill, makeDistant, offsetAndScale},
      {"one pixel differs in color", well, makeOddColor},
      {"one pixel differs in features", ill, makeOddFeatures},
      {"1..12 valid pixels", ill, makeFewValid},
      {"fireflies of 1e30", well, makeFireflies},
      {"denormal colors", well, makeDenormalColors},
      {"zero colors", well, makeZeroColors},
      {"negative colors", well, makeNegativeColors},
      {"NaN and Inf colors", well, makeBrokenColors},
      {"NaN and Inf positions", well, makeBrokenPositions},
      {"half-precision inputs", well, makeRich, storeAsHalf},
      {"no valid pixel", ill, makeAllBroken},
      {"all sky", ill, makeSky},
  };
  return table;
}

Batch makeBatch(const Family& family, std::uint32_t seed, std::uint32_t batchIndex, int count) {
  // Families differ in their random numbers, wherever they stand in the table.
  const std::uint64_t name = fnv1a(family.name.data(), family.name.size());
  Random random(name ^ (static_cast<std::uint64_t>(seed) << 32) ^ batchIndex);
  Batch batch;
  if (family.prepare != nullptr) family.prepare(batch, random);
  batch.blocks.resize(static_cast<std::size_t>(count));
  for (Block& block : batch.blocks) family.makeBlock(block, random);
  return batch;
}

}  // namespace quell::stress
