// Ports of the stage guided_evaluate; see common/ports.h for the columns.
#ifndef QUELL_GUIDED_EVALUATE_PORTS_H
#define QUELL_GUIDED_EVALUATE_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "guided_params.h"

// clang-format off
#define GUIDED_EVALUATE_OPTIONS(OPTION, SIZE)                                                \
  OPTION(QUELL_SIGNALS) OPTION(SUBSAMPLING) OPTION(SKIP) SIZE(cellFloats) SIZE(cellCount) SIZE(surfaceItems)

#define GUIDED_EVALUATE_PORTS(PORT, IMAGE, OUTPUT)                                                                              \
  PORT(windowCoefficients, READ,  FLOAT, RECORDS(cellFloats * QUELL_GUIDED_COEFFICIENTS * QUELL_SIGNALS), ELEMENTS(cellCount * QUELL_GUIDED_COEFFICIENTS * QUELL_SIGNALS) * (SKIP ? SURFACES : 1), ALWAYS) \
  PORT(guides,             READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS),                            PLANES(3), ALWAYS) \
  PORT(viewDepth,          READ,  FLOAT, 1,                                                               ALL,       ALWAYS) \
  PORT(guidedIrradiance,   WRITE, FLOAT, 3 * QUELL_SIGNALS,                                               ALL,       ALWAYS) \
  SURFACES_PORT(PORT)
// clang-format on

#endif
