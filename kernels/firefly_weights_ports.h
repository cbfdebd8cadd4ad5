// Ports of the stage firefly_weights; see common/ports.h for the columns.
#ifndef QUELL_FIREFLY_WEIGHTS_PORTS_H
#define QUELL_FIREFLY_WEIGHTS_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "firefly_weights_params.h"

// clang-format off
#define FIREFLY_WEIGHTS_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) OPTION(SKIP) SIZE(surfaceItems)

#define FIREFLY_WEIGHTS_PORTS(PORT, IMAGE, OUTPUT)                                                     \
  PORT(irradiance,    READ,  FLOAT, 3 * QUELL_SIGNALS,                    ALL,                   ALWAYS) \
  PORT(guides,        READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(QUELL_SIGNALS), ALWAYS) \
  PORT(historyLength, READ,  UCHAR, QUELL_SIGNALS,                        ALL,                   ALWAYS) \
  PORT(tapWeights,    WRITE, FLOAT, QUELL_SIGNALS,                        ALL,                   ALWAYS) \
  SURFACES_PORT(PORT)
// clang-format on

#endif
