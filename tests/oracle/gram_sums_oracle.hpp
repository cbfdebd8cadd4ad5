// Double-precision oracle of the stage gram_sums (normal equations of Koskela et al. 2019, eq. (2)), see
// kernels/gram_sums.cl.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernels/gram_params.h"
#include "tests/oracle/fit_oracle.hpp"

namespace quell::tests {

struct GramInputs {
  Planes irradiance;  ///< 3 planes
  Planes guides;      ///< 7 planes, and 4 of materials where features need them
  GramParams params{};
  int tileEdge = QUELL_BLOCK_EDGE;
  bool overlap = false;                ///< pixels outside the image are left out instead of mirrored
  FeatureNames list = defaultNames();  ///< whose sums are collected, see gramNamesOf()
};

using GramMatrix = Eigen::MatrixXd;

/// Of [features | colour], 0.
GramMatrix emptySums(const FeatureNames& list);

struct GramTile {
  explicit GramTile(const FeatureNames& list) : sums(emptySums(list)), range(list) {}

  GramMatrix sums;  ///< of [features | colour], symmetric
  VariableRange range;
};

std::vector<GramTile> gramSumsOracle(const GramInputs& inputs);

/// A tile as the device stores it.
GramTile unpackTile(const Planes& tiles, const GramParams& params, int tile, const FeatureNames& list);
Planes packTiles(const std::vector<GramTile>& tiles);

inline int gramTileCount(const GramParams& params) { return params.tilesX * params.tilesY; }

/// The pixels of a tile that count: with a weight, inside the image or mirrored into it (again and again,
/// maybe).
std::vector<BlockPixel> tilePixels(const GramInputs& inputs, int tile);

/// Adds a pixel's products of [features | colour], times its weight and `factor`.
void addPixel(const GramInputs& inputs, const FitRecord& scaling, BlockPixel pixel, double factor,
              GramMatrix& sums);

}  // namespace quell::tests
