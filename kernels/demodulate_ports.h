// Ports of the stage demodulate; see common/ports.h for the columns.
#ifndef QUELL_DEMODULATE_PORTS_H
#define QUELL_DEMODULATE_PORTS_H

#include "common/f_beta_ports.h"
#include "common/guides.h"
#include "common/ports.h"
#include "demodulate_params.h"

// clang-format off
#define DEMODULATE_OPTIONS(OPTION, SIZE)                                                       \
  OPTION(QUELL_SIGNALS) OPTION(DEMODULATED) OPTION(DEMODULATE) OPTION(SKIP) SIZE(surfaceItems)

#define DEMODULATE_PORTS(PORT, IMAGE, OUTPUT)                                                                                         \
  LIGHT_IMAGES(IMAGE, SURFACES)                                                                                                       \
  IMAGE(roughness, ROUGHNESS, SURFACES, ALWAYS)                                                                                       \
  F_BETA_PORTS(PORT, IMAGE)                                                                                                           \
  IMAGE(normalWorld, NORMALWORLD, 1, ALWAYS)                                                                                          \
  IMAGE(positionWorld, POSITIONWORLD, SURFACES, ALWAYS)                                                                               \
  IMAGE(viewDepth, VIEWDEPTH, SURFACES, ALWAYS)                                                                                       \
  PORT(irradiance, WRITE, FLOAT, 3 * QUELL_SIGNALS,                    SURFACES,                              ALWAYS)                 \
  PORT(guides,     WRITE, FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(QUELL_GUIDE_WEIGHT * SURFACES + QUELL_SIGNALS), ALWAYS) \
  PORT(viewDepth,  WRITE, FLOAT, 1,                                    ALL,                                   ALWAYS)                 \
  PORT(roughness,  WRITE, FLOAT, 1,                                    SURFACES,                              HAS(roughness))         \
  F_BETA_KEPT_PORT(PORT, WRITE, SURFACES)                                                                                             \
  PORT(surfaces,   WRITE, UCHAR, RECORDS(surfaceItems),                ALL,                                   SKIP)
// clang-format on

#endif
