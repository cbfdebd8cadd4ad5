// Ports of the stage virtual_motion; see common/ports.h for the columns.
#ifndef QUELL_VIRTUAL_MOTION_PORTS_H
#define QUELL_VIRTUAL_MOTION_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "virtual_motion_params.h"

// clang-format off
#define VIRTUAL_MOTION_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) OPTION(SKIP) SIZE(surfaceItems)

#define VIRTUAL_MOTION_PORTS(PORT, IMAGE, OUTPUT)                                                               \
  IMAGE(hitDistance, HITDISTANCE, SURFACES, ALWAYS)                                                             \
  PORT(guides,           READ,     FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(6),             ALWAYS) \
  PORT(guidesPrev,       PREVIOUS, FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(4) * HISTORIES, ALWAYS) \
  PORT(pixelPrev,        READ,     FLOAT, 2,                                    ALL,                   ALWAYS) \
  PORT(reprojectionMask, READ,     UCHAR, QUELL_SIGNALS,                        PLANES(1),             ALWAYS) \
  PORT(virtualPixelPrev, WRITE,    FLOAT, 2,                                    ALL,                   ALWAYS) \
  PORT(virtualMask,      WRITE,    UCHAR, 1,                                    ALL,                   ALWAYS) \
  PORT(virtualPositions, WRITE,    FLOAT, 3,                                    ALL,                   ALWAYS) \
  SURFACES_PORT(PORT)
// clang-format on

#endif
