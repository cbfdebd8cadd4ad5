// Ports of the stage soft_history; see common/ports.h for the columns.
#ifndef QUELL_SOFT_HISTORY_PORTS_H
#define QUELL_SOFT_HISTORY_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "soft_history_params.h"

// clang-format off
// Positions are the first planes of the guides, or those of virtual_motion.
#define SOFT_HISTORY_POSITION_PLANES (VIRTUAL ? 3 : QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS))

#define SOFT_HISTORY_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) OPTION(QUELL_SIGNAL) OPTION(VIRTUAL) OPTION(SKIP) SIZE(clamps) SIZE(surfaceItems)

#define SOFT_HISTORY_PORTS(PORT, IMAGE, OUTPUT)                                                                                         \
  PORT(irradiance,    READ,     FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3),                                         ALWAYS) \
  PORT(guides,        READ,     FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(clamps),                                    ALWAYS) \
  PORT(positions,     READ,     FLOAT, SOFT_HISTORY_POSITION_PLANES,         PLANES(3),                                         ALWAYS) \
  PORT(positionsPrev, PREVIOUS, FLOAT, SOFT_HISTORY_POSITION_PLANES,         PLANES(3) * HISTORIES,                             ALWAYS) \
  PORT(pixelPrev,     READ,     FLOAT, 2,                                    ALL,                                               ALWAYS) \
  PORT(tapMask,       READ,     UCHAR, (VIRTUAL ? 1 : QUELL_SIGNALS),        PLANES(1),                                         ALWAYS) \
  PORT(historyLength, READ,     UCHAR, QUELL_SIGNALS,                        PLANES(1),                                         ALWAYS) \
  PORT(historyPrev,   PREVIOUS, FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3) * HISTORIES,                             ALWAYS) \
  PORT(blended,       WRITE,    FLOAT, 3 * QUELL_SIGNALS,                    PLANES(3),                                         ALWAYS) \
  PORT(confidence,    WRITE,    FLOAT, QUELL_SIGNALS,                        PLANES(1),                                         ALWAYS) \
  SURFACES_PORT(PORT)
// clang-format on

#endif
