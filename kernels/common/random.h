// Counter-based random numbers: the same for every device, work-group size and lane count.
#ifndef QUELL_COMMON_RANDOM_H
#define QUELL_COMMON_RANDOM_H

#include "common/lanes.h"

// PCG-RXS-M-XS as a hash of 32 bits (Jarzynski and Olano 2020, Hash Functions for GPU Rendering, "pcg").
QUELL_INLINE uintL hashLanes(uintL v) {
  const uintL state = v * 747796405u + 2891336453u;
  const uintL word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

QUELL_INLINE uint hashScalar(uint v) {
  const uint state = v * 747796405u + 2891336453u;
  const uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

// Uniform in [-1, 1]: the bits as a signed number times 2^-31.
QUELL_INLINE floatL signedUnit(uintL bits) { return TO_FLOAT(AS_INT(bits)) * 4.6566128730773926e-10f; }

#endif
