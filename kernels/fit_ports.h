// Ports of the stage fit; see common/ports.h for the columns.
#ifndef QUELL_FIT_PORTS_H
#define QUELL_FIT_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "fit_params.h"

// clang-format off
#define FIT_OPTIONS(OPTION, SIZE)                                                                                                  \
  OPTION(QUELL_SIGNAL) OPTION(QUELL_USES_MATERIAL) OPTION(TAP_WEIGHTS) OPTION(SKIP) OPTION(GROUP_SIZE) OPTION(FIT_STORAGE_HALF) OPTION(FIT_UNROLL) \
  SIZE(QUELL_SIGNALS) SIZE(guidePlanes) SIZE(materialPlanes) SIZE(recordFloats) SIZE(storageHalves) SIZE(surfaceItems)

#define FIT_PORTS(PORT, IMAGE, OUTPUT)                                                                                 \
  PORT(irradiance, READ,    FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3),               ALWAYS)              \
  PORT(guides,     READ,    FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(guidePlanes + (TAP_WEIGHTS ? 0 : 1)), ALWAYS)              \
  PORT(tapWeights, READ, FLOAT, QUELL_SIGNALS, PLANES(1), TAP_WEIGHTS)              \
  PORT(materials,  READ,    FLOAT, QUELL_MATERIAL_PLANES,                PLANES(materialPlanes),  QUELL_USES_MATERIAL) \
  PORT(fitRecords, WRITE,   FLOAT, RECORDS(recordFloats),                ALL,                     ALWAYS)              \
  PORT(fitStorage, SCRATCH, HALF,  RECORDS(storageHalves),               ALL,                     FIT_STORAGE_HALF)    \
  SURFACES_PORT(PORT)
// clang-format on

#endif
