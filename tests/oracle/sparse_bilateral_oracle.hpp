// Double-precision oracle of the stage sparse_bilateral (Mara et al. 2017, stages 4 and 7), see kernels/sparse_bilateral.cl.
#pragma once

#include <array>
#include <vector>

#include "tests/oracle/edge_stops_oracle.hpp"

namespace quell::tests {

struct SparseBilateralInputs {
  Planes irradiance;  ///< 3 planes
  FilterGuides guides;
  Planes cellConfidence;    ///< 1 plane of cells; empty: the radius is the same everywhere
  Planes windowConfidence;  ///< 1 plane of cells
  EdgeStopParams stops{};
  double radius = 0.0;  ///< pixels
  double lowFactor = 1.0;
  std::uint32_t frameIndex = 1;
};

struct SparseBilateralExact {
  ExactPlanes irradiance;
  BasicPlanes<char>
      undecided;  ///< nothing but taps near the largest penalty, of which float knows too little
};

/// Pixels from the centre to the taps of a disc in that frame.
std::vector<std::array<int, 2>> sparseTaps(double radius, std::uint32_t frameIndex);

SparseBilateralExact sparseBilateralOracle(const SparseBilateralInputs& inputs);

}  // namespace quell::tests
