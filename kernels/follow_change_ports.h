// Ports of the stage follow_change; see common/ports.h for the columns.
#ifndef QUELL_FOLLOW_CHANGE_PORTS_H
#define QUELL_FOLLOW_CHANGE_PORTS_H

#include "change_params.h"
#include "common/guides.h"
#include "common/ports.h"

// clang-format off
#define FOLLOW_CHANGE_OPTIONS(OPTION, SIZE)                               \
  OPTION(QUELL_SIGNALS) OPTION(SKIP) SIZE(surfaceItems) SIZE(changeTiles)

#define FOLLOW_CHANGE_PORTS(PORT, IMAGE, OUTPUT)                                              \
  PORT(changeWeights,    READ,   FLOAT, RECORDS(changeTiles),                SURFACES,     ALWAYS) \
  PORT(newestIrradiance, READ,   FLOAT, 3 * QUELL_SIGNALS,                   CHANGED, ALWAYS) \
  PORT(irradiance,       UPDATE, FLOAT, 3 * QUELL_SIGNALS,                   CHANGED, ALWAYS) \
  PORT(moments,          UPDATE, FLOAT, QUELL_MOMENT_PLANES * QUELL_SIGNALS, CHANGED, ALWAYS) \
  PORT(historyLength,    UPDATE, UCHAR, QUELL_SIGNALS,                       CHANGED, ALWAYS) \
  SURFACES_PORT(PORT)
// clang-format on

#endif
