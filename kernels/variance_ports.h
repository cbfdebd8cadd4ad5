// Ports of the stage variance; see common/ports.h for the columns.
#ifndef QUELL_VARIANCE_PORTS_H
#define QUELL_VARIANCE_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "variance_params.h"

// clang-format off
#define VARIANCE_OPTIONS(OPTION, SIZE)                                  \
  OPTION(QUELL_SIGNALS) OPTION(OF_MEAN) OPTION(STOP_LUMINANCE) OPTION(FIREFLIES) OPTION(ROUGHNESS_STOP) OPTION(SKIP) SIZE(surfaceItems) SIZE(temporalFrames)

#define VARIANCE_PORTS(PORT, IMAGE, OUTPUT)                                                                                    \
  PORT(moments,       READ,  FLOAT, QUELL_MOMENT_PLANES * QUELL_SIGNALS,  ALL,                                   ALWAYS)       \
  PORT(historyLength, READ,  UCHAR, QUELL_SIGNALS,                        ALL,                                   ALWAYS)       \
  PORT(guides,        READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), STOP_LUMINANCE || FIREFLIES ? PLANES(QUELL_SIGNALS) + SHORT_HISTORIES * PLANES(3) : SHORT_HISTORIES * PLANES(3 + QUELL_SIGNALS), ALWAYS) \
  PORT(viewDepth,     READ,  FLOAT, 1,                                    SHORT_HISTORIES,                       ALWAYS)       \
  PORT(irradiance,    READ,  FLOAT, 3 * QUELL_SIGNALS,                    ALL,                                   STOP_LUMINANCE || FIREFLIES) \
  PORT(stopLuminance, WRITE, FLOAT, QUELL_SIGNALS,                        ALL,                                   STOP_LUMINANCE) \
  PORT(tapWeights,    WRITE, FLOAT, QUELL_SIGNALS,                        ALL,                                   FIREFLIES) \
  PORT(variance,      WRITE, FLOAT, QUELL_SIGNALS,                        ALL,                                   ALWAYS)       \
  SURFACES_PORT(PORT)
// clang-format on

#endif
