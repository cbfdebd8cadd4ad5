// Ports of the stage gram_sums; see common/ports.h for the columns.
#ifndef QUELL_GRAM_SUMS_PORTS_H
#define QUELL_GRAM_SUMS_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "gram_params.h"

// clang-format off
#define GRAM_SUMS_OPTIONS(OPTION, SIZE)                                                                                            \
  OPTION(QUELL_SIGNAL) OPTION(QUELL_USES_MATERIAL) OPTION(TAP_WEIGHTS) OPTION(SKIP) OPTION(GROUP_SIZE) OPTION(GRAM_TILE_EDGE) OPTION(GRAM_MIRROR) \
  SIZE(QUELL_SIGNALS) SIZE(guidePlanes) SIZE(materialPlanes) SIZE(tileFloats) SIZE(surfaceItems)

#define GRAM_SUMS_PORTS(PORT, IMAGE, OUTPUT)                                                                         \
  PORT(irradiance, READ,  FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3),               ALWAYS)              \
  PORT(guides,     READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(guidePlanes + (TAP_WEIGHTS ? 0 : 1)), ALWAYS)              \
  PORT(tapWeights, READ, FLOAT, QUELL_SIGNALS, PLANES(1), TAP_WEIGHTS)              \
  PORT(materials,  READ,  FLOAT, QUELL_MATERIAL_PLANES,                PLANES(materialPlanes),  QUELL_USES_MATERIAL) \
  PORT(gramTiles,  WRITE, FLOAT, RECORDS(tileFloats),                  ALL,                     ALWAYS)              \
  SURFACES_PORT(PORT)
// clang-format on

#endif
