// Ports of the stage remodulate; see common/ports.h for the columns.
#ifndef QUELL_REMODULATE_PORTS_H
#define QUELL_REMODULATE_PORTS_H

#include "common/display_modes.h"
#include "common/f_beta_ports.h"
#include "common/guides.h"
#include "common/ports.h"
#include "remodulate_params.h"

// clang-format off
#define REMODULATE_OPTIONS(OPTION, SIZE)                                                                      \
  OPTION(QUELL_SIGNALS) OPTION(DEMODULATED) OPTION(DEMODULATE) OPTION(WRITE_PLANES) OPTION(ANTIALIAS_LINEAR) \
  OPTION(KEEP_LIGHT) OPTION(SKIP) DISPLAY_OPTIONS(OPTION) SIZE(surfaceItems) SIZE(lightTiles)

#define REMODULATE_PORTS(PORT, IMAGE, OUTPUT)                                                                  \
  PORT(filtered,  READ,  FLOAT, 3 * QUELL_SIGNALS,                    ALL,                       ALWAYS)       \
  PORT(guides,    READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(3 + QUELL_SIGNALS), ALWAYS)       \
  PORT(lightGain, READ,  FLOAT, RECORDS(lightTiles),                  SURFACES,                  KEEP_LIGHT)   \
  F_BETA_KEPT_PORT(PORT, READ, 1)                                                                              \
  LIGHT_IMAGES(IMAGE, 1)                                                                                       \
  IMAGE(f0, F0, 1, F0_DIMS_GLOSS)                                                                              \
  PORT(beforeAntialiasing,  WRITE, FLOAT, 3,                                    ALL,                       WRITE_PLANES) \
  OUTPUT(linear, LINEAR, 1, !ANTIALIAS_LINEAR)                                                                 \
  OUTPUT(display, DISPLAY, 1, !WRITE_PLANES)                                                                   \
  SURFACES_PORT(PORT)
// clang-format on

#endif
