// Ports of the stage accumulate_noisy; see common/ports.h for the columns.
#ifndef QUELL_ACCUMULATE_NOISY_PORTS_H
#define QUELL_ACCUMULATE_NOISY_PORTS_H

#include "accumulate_noisy_params.h"
#include "common/f_beta_ports.h"
#include "common/ports.h"

// clang-format off
#define ACCUMULATE_NOISY_OPTIONS(OPTION, SIZE)                                                                          \
  OPTION(QUELL_SIGNALS) OPTION(DEMODULATED) OPTION(DEMODULATE) OPTION(MOMENTS) OPTION(FILTER_GUIDES) OPTION(INNOVATION) \
  OPTION(SKIP) SIZE(surfaceItems) SIZE(antialiasBackground)

#define ACCUMULATE_NOISY_PORTS(PORT, IMAGE, OUTPUT)                                                                                         \
  LIGHT_IMAGES(IMAGE, SURFACES)                                                                                                             \
  IMAGE(roughness, ROUGHNESS, SURFACES, FILTER_GUIDES || DEMODULATE == QUELL_DEMODULATE_F_BETA)                                             \
  F_BETA_PORTS(PORT, IMAGE)                                                                                                                 \
  IMAGE(normalWorld, NORMALWORLD, 1, ALWAYS)                                                                                                \
  IMAGE(positionWorld, POSITIONWORLD, SURFACES, ALWAYS)                                                                                     \
  IMAGE(viewDepth, VIEWDEPTH, SURFACES, ALWAYS)                                                                                             \
  IMAGE(motion, MOTION, SURFACES, ALWAYS)                                                                                                   \
  IMAGE(objectId, OBJECTID, SURFACES, ALWAYS)                                                                                               \
  PORT(irradiancePrev,    PREVIOUS, FLOAT, 3 * QUELL_SIGNALS,                       SURFACES * HISTORIES,                           ALWAYS)          \
  PORT(historyLengthPrev, PREVIOUS, UCHAR, QUELL_SIGNALS,                           SURFACES * HISTORIES,                           ALWAYS)          \
  PORT(guidesPrev,        PREVIOUS, FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS),    SURFACES * HISTORIES,                           ALWAYS)          \
  PORT(momentsPrev,       PREVIOUS, FLOAT, QUELL_MOMENT_PLANES * QUELL_SIGNALS,     SURFACES * HISTORIES,                           MOMENTS)         \
  PORT(objectIdsPrev,     PREVIOUS, INT,   1,                                       SURFACES * HISTORIES,                           HAS(objectId))   \
  PORT(irradiance,        WRITE,    FLOAT, 3 * QUELL_SIGNALS,                       SURFACES,                              ALWAYS)          \
  PORT(historyLength,     WRITE,    UCHAR, QUELL_SIGNALS,                           ALL,                                   ALWAYS)          \
  PORT(guides,            WRITE,    FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS),    PLANES(QUELL_GUIDE_WEIGHT * SURFACES + QUELL_SIGNALS), ALWAYS)\
  PORT(moments,           WRITE,    FLOAT, QUELL_MOMENT_PLANES * QUELL_SIGNALS,     SURFACES,                              MOMENTS)         \
  PORT(objectIds,         WRITE,    INT,   1,                                       SURFACES,                              HAS(objectId))   \
  PORT(pixelPrev,         WRITE,    FLOAT, 2,                                       WHERE_REPROJECTED,                     ALWAYS)          \
  PORT(reprojectionMask,  WRITE,    UCHAR, QUELL_SIGNALS,                           ALL,                                   ALWAYS)          \
  PORT(viewDepth,         WRITE,    FLOAT, 1,                                       ALL,                                   FILTER_GUIDES)   \
  PORT(roughness,         WRITE,    FLOAT, 1,                                       SURFACES,                              FILTER_GUIDES && HAS(roughness))\
  F_BETA_KEPT_PORT(PORT, WRITE, SURFACES)                                                                                                   \
  PORT(newestIrradiance,  WRITE,    FLOAT, 3 * QUELL_SIGNALS,                       SURFACES,                              INNOVATION)      \
  PORT(innovation,        WRITE,    FLOAT, QUELL_INNOVATION_PLANES * QUELL_SIGNALS, SURFACES,                              INNOVATION)      \
  PORT(surfaces,          WRITE,    UCHAR, RECORDS(surfaceItems),                   ALL,                                   SKIP)
// clang-format on

#endif
