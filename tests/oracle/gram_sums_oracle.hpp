// Double-precision oracle of the stage gram_sums (normal equations of Koskela et al. 2019, eq. (2)), see
// kernels/gram_sums.cl.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "kernels/gram_params.h"
#include "tests/oracle/fit_oracle.hpp"

namespace quell::tests {

struct GramInputs {
  Planes irradiance;  ///< 3 planes
  Planes guides;      ///< 7 planes
  GramParams params{};
  int tileEdge = QUELL_BLOCK_EDGE;
  bool overlap = false;  ///< pixels outside the image are left out instead of mirrored
};

using GramMatrix = Eigen::Matrix<double, QUELL_FIT_COLUMNS, QUELL_FIT_COLUMNS>;

/// Range of positions; low > high where there is none.
struct PositionRange {
  std::array<double, 3> low, high;

  PositionRange();
  bool empty() const { return low[0] > high[0]; }
  void include(const std::array<double, 3>& lowest, const std::array<double, 3>& highest);
};

struct GramTile {
  GramMatrix sums = GramMatrix::Zero();  ///< of [features | colour], symmetric
  PositionRange range;
};

std::vector<GramTile> gramSumsOracle(const GramInputs& inputs);

/// A tile as the device stores it.
GramTile unpackTile(const Planes& tiles, const GramParams& params, int tile);
Planes packTiles(const std::vector<GramTile>& tiles);

inline int gramTileCount(const GramParams& params) { return params.tilesX * params.tilesY; }

/// The pixels of a tile that count: with a weight, inside the image or mirrored into it (again and again,
/// maybe).
std::vector<BlockPixel> tilePixels(const GramInputs& inputs, int tile);

/// A record without coefficients that maps the range to [0, 1].
FitRecord scalingOf(const PositionRange& range);

/// Adds a pixel's products of [features | colour], times its weight and `factor`.
void addPixel(const GramInputs& inputs, const FitRecord& scaling, BlockPixel pixel, double factor,
              GramMatrix& sums);

}  // namespace quell::tests
