// Ports of the stage blended_sum; see common/ports.h for the columns.
#ifndef QUELL_BLENDED_SUM_PORTS_H
#define QUELL_BLENDED_SUM_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "gram_params.h"

// clang-format off
#define BLENDED_SUM_OPTIONS(OPTION, SIZE)                                                          \
  OPTION(QUELL_SIGNAL) OPTION(QUELL_USES_MATERIAL) OPTION(SKIP) OPTION(GRAM_TILE_EDGE)             \
  SIZE(QUELL_SIGNALS) SIZE(guidePlanes) SIZE(materialPlanes) SIZE(recordFloats) SIZE(surfaceItems)

#define BLENDED_SUM_PORTS(PORT, IMAGE, OUTPUT)                                                                      \
  PORT(fitRecords, READ,  FLOAT, RECORDS(recordFloats),                ALL,                    ALWAYS)              \
  PORT(guides,     READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(guidePlanes),    ALWAYS)              \
  PORT(materials,  READ,  FLOAT, QUELL_MATERIAL_PLANES,                PLANES(materialPlanes), QUELL_USES_MATERIAL) \
  PORT(fitted,     WRITE, FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3),              ALWAYS)              \
  SURFACES_PORT(PORT)
// clang-format on

#endif
