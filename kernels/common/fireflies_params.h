// Constants of common/fireflies.h.
#ifndef QUELL_COMMON_FIREFLIES_PARAMS_H
#define QUELL_COMMON_FIREFLIES_PARAMS_H

// Distance of the ring that a pixel is compared with, pixels along the larger of the two axes: three frames of motion
// spread a firefly over 4x4 pixels.
#define QUELL_FIREFLY_RING 3

// Frames of history from which on a pixel can be told from its ring: where light comes by rare samples most pixels have
// none before.
#define QUELL_FIREFLY_LEAST_HISTORY 4

// Least share of its weight that a firefly keeps: where there is nothing else it still counts.
#define QUELL_LEAST_FIREFLY_SHARE 1e-12f

#endif
