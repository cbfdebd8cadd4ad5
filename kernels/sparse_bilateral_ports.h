// Ports of the stage sparse_bilateral; see common/ports.h for the columns.
#ifndef QUELL_SPARSE_BILATERAL_PORTS_H
#define QUELL_SPARSE_BILATERAL_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "sparse_bilateral_params.h"

// clang-format off
#define SPARSE_BILATERAL_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) OPTION(CELL_RADIUS) OPTION(ROUGHNESS_STOP) OPTION(SKIP) SIZE(cellFloats) SIZE(cellCount) SIZE(surfaceItems)

#define SPARSE_BILATERAL_PORTS(PORT, IMAGE, OUTPUT)                                                                           \
  PORT(sparseInput,      READ,  FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3),           ALWAYS)      \
  PORT(guides,           READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(4),           ALWAYS)      \
  PORT(viewDepth,        READ,  FLOAT, 1,                                    ALL,                 ALWAYS)      \
  PORT(cellConfidence,   READ,  FLOAT, RECORDS(cellFloats),                  ELEMENTS(cellCount), CELL_RADIUS) \
  PORT(windowConfidence, READ,  FLOAT, RECORDS(cellFloats),                  ELEMENTS(cellCount), CELL_RADIUS) \
  PORT(sparseOutput,     WRITE, FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3),           ALWAYS)      \
  SURFACES_PORT(PORT)
// clang-format on

#endif
