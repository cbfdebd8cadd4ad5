// What accumulation leaves behind for filters and for the next frame: planes of guides, bits of the reprojection mask.
#ifndef QUELL_COMMON_GUIDES_H
#define QUELL_COMMON_GUIDES_H

// Planes of the guides; with two signals a second weight follows. The normal is turned where light has no factor in a
// channel (filteredNormal() in common/filter_input.h), and 0 where the pixel cannot be filtered.
#define QUELL_GUIDE_POSITION 0  // camera-relative position, 3 planes
#define QUELL_GUIDE_NORMAL 3    // world-space normal, 3 planes
#define QUELL_GUIDE_WEIGHT 6    // weight as a filter tap per signal: 0 where there is no sample, else 1
#define QUELL_GUIDE_PLANES_OF(signals) (QUELL_GUIDE_WEIGHT + (signals))

// Planes of the moments of luminance, per signal.
#define QUELL_MOMENT_FIRST 0
#define QUELL_MOMENT_SECOND 1
#define QUELL_MOMENT_PLANES 2

// The history length is stored in a byte (Koskela et al. 2019, phase I: "8-bit integers").
#define QUELL_MAX_HISTORY_LENGTH 255

// Bits of the reprojection mask, one plane per signal.
#define QUELL_TAP_ACCEPTED(i) (1 << (i))  // bilinear tap i shows the same surface
#define QUELL_PREV_IN_FRAME 16            // the pixel lay inside the frame before
#define QUELL_HISTORY_REJECTED 32         // a surface without any history there

#endif
