// Blocks whose features make trouble; their radiance is plain lighting (signals.hpp), gentle where the family
// is ill-posed: even the best fit of a shadow's edge overshoots by more than such a family may.
#pragma once

#include "host/stress/block.hpp"
#include "host/stress/geometry.hpp"
#include "host/stress/random.hpp"

namespace quell::stress {

/// Features alone, without radiance, that determine all ten coefficients: waves, roughened like foliage.
void addRichSurface(Block& block, const View& view, Random& random);

void makeRich(Block& block, Random& random);
/// Waves with the normal of none of their points.
void makeConstantNormals(Block& block, Random& random);
void makeAlignedPlane(Block& block, Random& random);
/// No component of the normal below 0.5.
void makeObliquePlane(Block& block, Random& random);
/// Tilted by 1e-7 to 1e-2: one axis of the positions is a vanishing combination of the other two.
void makeNearlyAlignedPlane(Block& block, Random& random);
void makeConstantFeatures(Block& block, Random& random);
/// Positions vary by 1e-8 to 1e-3 of the distance, normals by 1e-8 to 1e-3.
void makeNearlyConstantFeatures(Block& block, Random& random);
/// Columns that are equal to the last bit.
void makeDuplicatedFeatures(Block& block, Random& random);
/// Spheres, whose normals follow from their positions, and columns that differ by 1e-7 to 1e-2.
void makeNearlyDuplicatedFeatures(Block& block, Random& random);
/// Two surfaces side by side; the farther is up to 1e4 times as far from the camera.
void makeSurfaceEdge(Block& block, Random& random);
/// A surface beside the sky.
void makeSkyEdge(Block& block, Random& random);
/// A surface pushed away from the camera by 1e2 to 1e7, as through a telescope.
void makeDistant(Block& block, Random& random);
/// At 1e8 to 1e17 scene units, its extent 1e-6 to 1e-3 of that: fourth powers of positions would overflow.
void makeVeryDistant(Block& block, Random& random);
/// All pixels equal in their features but one.
void makeOddFeatures(Block& block, Random& random);

}  // namespace quell::stress
