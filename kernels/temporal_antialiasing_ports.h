// Ports of the stage temporal_antialiasing; see common/ports.h for the columns.
#ifndef QUELL_TEMPORAL_ANTIALIASING_PORTS_H
#define QUELL_TEMPORAL_ANTIALIASING_PORTS_H

#include "common/display_modes.h"
#include "common/ports.h"
#include "temporal_antialiasing_params.h"

// clang-format off
#define TEMPORAL_ANTIALIASING_OPTIONS(OPTION, SIZE)   \
  OPTION(SKIP) OPTION(ANTIALIAS_LINEAR) DISPLAY_OPTIONS(OPTION) SIZE(QUELL_SIGNALS) SIZE(surfaceItems)

#define TEMPORAL_ANTIALIASING_PORTS(PORT, IMAGE, OUTPUT)                    \
  PORT(beforeAntialiasing,         READ,     FLOAT, 3,             ALL,       ALWAYS) \
  PORT(antialiasedPrev,  PREVIOUS, FLOAT, 3,             HISTORIES, ALWAYS) \
  PORT(pixelPrev,        READ,     FLOAT, 2,             ALL,       ALWAYS) \
  PORT(reprojectionMask, READ,     UCHAR, QUELL_SIGNALS, PLANES(1), ALWAYS) \
  PORT(viewDepth,        READ,     FLOAT, 1,             ALL,       ALWAYS) \
  PORT(antialiased,      WRITE,    FLOAT, 3,             ALL,       ALWAYS) \
  OUTPUT(linear, LINEAR, 1, ANTIALIAS_LINEAR)                               \
  OUTPUT(display, DISPLAY, 1, ALWAYS)                                       \
  SURFACES_PORT(PORT)
// clang-format on

#endif
