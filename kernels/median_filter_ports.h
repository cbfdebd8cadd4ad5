// Ports of the stage median_filter; see common/ports.h for the columns.
#ifndef QUELL_MEDIAN_FILTER_PORTS_H
#define QUELL_MEDIAN_FILTER_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "median_filter_params.h"

// clang-format off
#define MEDIAN_FILTER_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) OPTION(SKIP) SIZE(surfaceItems)

#define MEDIAN_FILTER_PORTS(PORT, IMAGE, OUTPUT)                                                       \
  PORT(medianInput,  READ,  FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3), ALWAYS) \
  PORT(guides,       READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(1), ALWAYS) \
  PORT(medianOutput, WRITE, FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3), ALWAYS) \
  SURFACES_PORT(PORT)
// clang-format on

#endif
