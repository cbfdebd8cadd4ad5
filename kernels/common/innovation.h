// Layout of the innovation: how far a newest sample is from its history. Planes per signal.
#ifndef QUELL_COMMON_INNOVATION_H
#define QUELL_COMMON_INNOVATION_H

#define QUELL_INNOVATION_LUMINANCE 0
// Red minus blue: lights of one brightness that take turns differ most from warm to cold.
#define QUELL_INNOVATION_CHROMINANCE 1
#define QUELL_INNOVATION_PLANES 2
// A difference below this share of the sample's luminance is rounding and counts as 0: light without noise that stays must
// not look like a change, however little noise there is to compare with.
#define QUELL_LEAST_INNOVATION 1e-6f

#endif
