// Ports of the stage accumulate_filtered; see common/ports.h for the columns.
#ifndef QUELL_ACCUMULATE_FILTERED_PORTS_H
#define QUELL_ACCUMULATE_FILTERED_PORTS_H

#include "accumulate_filtered_params.h"
#include "common/ports.h"

// clang-format off
#define ACCUMULATE_FILTERED_OPTIONS(OPTION, SIZE)       \
  OPTION(QUELL_SIGNALS) OPTION(SKIP) SIZE(surfaceItems)

#define ACCUMULATE_FILTERED_PORTS(PORT, IMAGE, OUTPUT)                          \
  PORT(fitted,           READ,     FLOAT, 3 * QUELL_SIGNALS, ALL,       ALWAYS) \
  PORT(filteredPrev,     PREVIOUS, FLOAT, 3 * QUELL_SIGNALS, HISTORIES, ALWAYS) \
  PORT(pixelPrev,        READ,     FLOAT, 2,                 ALL,       ALWAYS) \
  PORT(reprojectionMask, READ,     UCHAR, QUELL_SIGNALS,     ALL,       ALWAYS) \
  PORT(historyLength,    READ,     UCHAR, QUELL_SIGNALS,     ALL,       ALWAYS) \
  PORT(filtered,         WRITE,    FLOAT, 3 * QUELL_SIGNALS, ALL,       ALWAYS) \
  SURFACES_PORT(PORT)
// clang-format on

#endif
