// Ports of the stage guided_moments; see common/ports.h for the columns.
#ifndef QUELL_GUIDED_MOMENTS_PORTS_H
#define QUELL_GUIDED_MOMENTS_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "guided_params.h"

// clang-format off
#define GUIDED_MOMENTS_OPTIONS(OPTION, SIZE)                                  \
  OPTION(QUELL_SIGNALS) OPTION(SUBSAMPLING) OPTION(TAP_WEIGHTS) OPTION(SKIP) \
  SIZE(cellFloats) SIZE(cellCount) SIZE(surfaceItems)

#define GUIDED_MOMENTS_PORTS(PORT, IMAGE, OUTPUT)                                                                               \
  PORT(irradiance, READ,  FLOAT, 3 * QUELL_SIGNALS,                             ALL,                                        ALWAYS)      \
  PORT(guides,     READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS),          PLANES(TAP_WEIGHTS ? 3 : 3 + QUELL_SIGNALS), ALWAYS)      \
  PORT(tapWeights, READ,  FLOAT, QUELL_SIGNALS,                                 ALL,                                        TAP_WEIGHTS) \
  PORT(viewDepth,  READ,  FLOAT, 1,                                             ALL,                                        ALWAYS)      \
  PORT(moments,    WRITE, FLOAT, RECORDS(cellFloats * QUELL_GUIDED_SUMS * QUELL_SIGNALS), ELEMENTS(cellCount * QUELL_GUIDED_SUMS * QUELL_SIGNALS), ALWAYS)      \
  SURFACES_PORT(PORT)
// clang-format on

#endif
