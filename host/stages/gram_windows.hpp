// Which windows a gram fit uses, and the tile grid that gram_sums, gram_solve and blended_sum share.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/fit_options.hpp"
#include "kernels/gram_params.h"

namespace quell {

/// Windows of a fit from tile sums.
struct GramWindows {
  /// False: blocks of 32 pixels, displaced from frame to frame and mirrored at the border, as the stage fit
  /// has them. True: tiles of `tileEdge` pixels; a window is a tile with its eight neighbours under a tent.
  bool overlap = false;
  int tileEdge = QUELL_BLOCK_EDGE;  ///< pixels: 32 for blocks, 8 or 16 for overlapping windows
};

/// The tile grid of one frame. `noiseAmplitude`: epsilon of the stochastic regularisation that is matched in
/// expectation, scaled feature units, >= 0; uniform noise of that amplitude has the variance epsilon^2 / 3.
GramParams makeGramParams(const GramWindows& windows, Size size, std::uint32_t frameIndex,
                          double noiseAmplitude);

/// Floats of the buffers "gramTiles" and "fitRecords".
int gramTileFloats(const GramWindows& windows, Size size, const FitFeatures& features);
int gramRecordFloats(const GramWindows& windows, Size size, const FitFeatures& features);

}  // namespace quell
