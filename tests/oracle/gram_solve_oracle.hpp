// Double-precision oracle of the stage gram_solve: ridge regression of a window, see kernels/gram_solve.cl.
#pragma once

#include "tests/oracle/gram_sums_oracle.hpp"

namespace quell::tests {

struct GramSolveInputs {
  Planes tiles;  ///< as the stage gram_sums writes them
  GramParams params{};
  bool overlap = false;  ///< a window is a tile with its eight neighbours under a tent, else a tile
  FeatureNames list = defaultNames();      ///< of the fit
  FeatureNames gramList = defaultNames();  ///< of the sums: the same first, then others
};

/// Sums of a window in its own scaling.
struct GramWindow {
  explicit GramWindow(const FeatureNames& list) : sums(emptySums(list)), scaling(list) {}

  GramMatrix sums;
  FitRecord scaling;
};

/// From the sums of tiles, taken to the window's scaling as M G M^T.
GramWindow windowOfTiles(const GramSolveInputs& inputs, int window);
/// The same straight from the pixels, in the window's scaling from the start.
GramWindow windowOfPixels(const GramInputs& inputs, int window);

/// A tile of a window and the height of the tent above it.
struct WindowTile {
  int tile;
  double tent;
};
std::vector<WindowTile> windowTiles(const GramParams& params, bool overlap, int window);

/// What solves a window.
struct GramFit {
  FitRecord record;
  double condition = 1.0;  ///< of the centred, regularised matrix with unit diagonal
  /// Within rounding of a threshold: float and double may take a different set of features.
  bool undecided = false;
};
/// Of the first features of the window's sums, those of `list`.
GramFit ridgeFit(const GramWindow& window, const FeatureNames& list, double noiseVariance);

std::vector<GramFit> gramSolveOracle(const GramSolveInputs& inputs);

}  // namespace quell::tests
