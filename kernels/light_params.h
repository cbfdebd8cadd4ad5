// Parameters and records of the stages light_sums and light_gain, and what remodulate makes of the gains.
#ifndef QUELL_LIGHT_PARAMS_H
#define QUELL_LIGHT_PARAMS_H

#include "common/tiles_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct LightParams {
  PlaneParams planes;
  QuellInt tilesX;
  QuellInt tilesY;
} LightParams;

QUELL_NAMESPACE_END

// A tile's record, per signal: weighted sums.
#define QUELL_LIGHT_LOST 0     // of the luminance of the history, less that of the filtered irradiance
#define QUELL_LIGHT_SQUARES 1  // of the squared luminance of the filtered irradiance
#define QUELL_LIGHT_RECORD 2

// A tile counts as having lost at most so many times the light that is left: more is a firefly, of which those in the
// corner of four tiles would pass for what all have lost.
#define QUELL_LIGHT_MOST_LOST 2.0f

// Of the rows of a tile one in so many is summed: luminance of the history comes averaged over 3x3 pixels.
#define QUELL_LIGHT_ROW_STEP 2

// Windows are tents of this many tiles, less one, on either side of the middle: they fall to 0 at 48 pixels.
#define QUELL_LIGHT_WINDOW 5
// Tiles of a row that are loaded for a window, a multiple of four.
#define QUELL_LIGHT_COLUMNS 12

// Numbers of that many records, and what windows in the last row load behind them.
#define QUELL_LIGHT_NUMBERS(tiles) (((tiles) + QUELL_LIGHT_COLUMNS) * QUELL_LIGHT_RECORD)

// Largest gain, 1 / luminance: its product with any luminance is finite.
#define QUELL_LIGHT_MOST_GAIN 1e30f
// What a pixel's ratio is limited to.
#define QUELL_LIGHT_LEAST_RATIO 0.5f
#define QUELL_LIGHT_MOST_RATIO 2.0f

#endif
