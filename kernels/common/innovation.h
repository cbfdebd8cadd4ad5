// Layout of the innovation: how far a newest sample is from its history. Planes per signal.
#ifndef QUELL_COMMON_INNOVATION_H
#define QUELL_COMMON_INNOVATION_H

#define QUELL_INNOVATION_LUMINANCE 0
// Red minus blue: lights of one brightness that take turns differ most from warm to cold.
#define QUELL_INNOVATION_CHROMINANCE 1
#define QUELL_INNOVATION_PLANES 2

#endif
