// The grid of tiles that some stages keep records of.
#ifndef QUELL_COMMON_TILES_PARAMS_H
#define QUELL_COMMON_TILES_PARAMS_H

// Edge of a tile, pixels.
#define QUELL_TILE 8

#endif
