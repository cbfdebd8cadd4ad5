// Ports of the stage background; see common/ports.h for the columns.
#ifndef QUELL_BACKGROUND_PORTS_H
#define QUELL_BACKGROUND_PORTS_H

#include "background_params.h"
#include "common/display_modes.h"
#include "common/ports.h"

// clang-format off
#define BACKGROUND_OPTIONS(OPTION, SIZE)                                                                                                   \
  OPTION(QUELL_SIGNALS) OPTION(DEMODULATED) OPTION(DEMODULATE) OPTION(ANTIALIAS) OPTION(ANTIALIAS_LINEAR) OPTION(SKIP) DISPLAY_OPTIONS(OPTION) SIZE(surfaceItems) SIZE(antialiasBackground)

#define BACKGROUND_PORTS(PORT, IMAGE, OUTPUT)                                            \
  LIGHT_IMAGES(IMAGE, 1)                                                                 \
  IMAGE(f0, F0, 1, F0_DIMS_GLOSS)                                                        \
  SURFACES_PORT(PORT)                                                                    \
  PORT(beforeAntialiasing,    WRITE, FLOAT, 3, antialiasBackground ? 1 : NEAR_SURFACES, ANTIALIAS) \
  PORT(antialiased, WRITE, FLOAT, 3, antialiasBackground ? 0 : 1,           ANTIALIAS)   \
  OUTPUT(linear, LINEAR, 1, ALWAYS)                                                      \
  OUTPUT(display, DISPLAY, antialiasBackground ? 0 : 1, ALWAYS)
// clang-format on

#endif
