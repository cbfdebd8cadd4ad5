// Ports of the stage separable_bilateral; see common/ports.h for the columns.
#ifndef QUELL_SEPARABLE_BILATERAL_PORTS_H
#define QUELL_SEPARABLE_BILATERAL_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "separable_bilateral_params.h"

// clang-format off
#define SEPARABLE_BILATERAL_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) OPTION(QUELL_SIGNAL) OPTION(ROUGHNESS_STOP) OPTION(SKIP) SIZE(surfaceItems)

#define SEPARABLE_BILATERAL_PORTS(PORT, IMAGE, OUTPUT)                                                              \
  PORT(separableInput,  READ,  FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3), ALWAYS)         \
  PORT(guides,          READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(4), ALWAYS)         \
  PORT(viewDepth,       READ,  FLOAT, 1,                                    ALL,       ALWAYS)         \
  PORT(roughness,       READ,  FLOAT, 1,                                    ALL,       ROUGHNESS_STOP) \
  PORT(separableOutput, WRITE, FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3), ALWAYS)         \
  SURFACES_PORT(PORT)
// clang-format on

#endif
