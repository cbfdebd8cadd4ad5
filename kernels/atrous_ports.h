// Ports of the stage atrous; see common/ports.h for the columns.
#ifndef QUELL_ATROUS_PORTS_H
#define QUELL_ATROUS_PORTS_H

#include "atrous_params.h"
#include "common/guides.h"
#include "common/ports.h"

// clang-format off
#define ATROUS_OPTIONS(OPTION, SIZE)                                                                                           \
  OPTION(QUELL_SIGNALS) OPTION(VARIANCE) OPTION(STOP_LUMINANCE) OPTION(TAP_WEIGHTS) OPTION(ROUGHNESS_STOP) OPTION(TAP_RADIUS) \
  OPTION(SKIP) SIZE(surfaceItems) SIZE(filtersVariance)

#define ATROUS_PORTS(PORT, IMAGE, OUTPUT)                                                                                  \
  PORT(irradiance,         READ,  FLOAT, 3 * QUELL_SIGNALS,                    ALL,                       ALWAYS)          \
  PORT(variance,           READ,  FLOAT, QUELL_SIGNALS,                        ALL,                       VARIANCE)        \
  PORT(guides,             READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(TAP_WEIGHTS ? 3 : 3 + QUELL_SIGNALS), ALWAYS) \
  PORT(tapWeights,         READ,  FLOAT, QUELL_SIGNALS,                        ALL,                       TAP_WEIGHTS)     \
  PORT(viewDepth,          READ,  FLOAT, 1,                                    ALL,                       ALWAYS)          \
  PORT(roughness,          READ,  FLOAT, 1,                                    ALL,                       ROUGHNESS_STOP)  \
  PORT(stopLuminance,      READ,  FLOAT, QUELL_SIGNALS,                        ALL,                       STOP_LUMINANCE)        \
  PORT(filteredIrradiance, WRITE, FLOAT, 3 * QUELL_SIGNALS,                    ALL,                       ALWAYS)          \
  PORT(filteredVariance,   WRITE, FLOAT, QUELL_SIGNALS,                        PLANES(filtersVariance * QUELL_SIGNALS), VARIANCE) \
  SURFACES_PORT(PORT)
// clang-format on

#endif
