// Ports of the stage light_sums; see common/ports.h for the columns.
#ifndef QUELL_LIGHT_SUMS_PORTS_H
#define QUELL_LIGHT_SUMS_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "light_params.h"

// clang-format off
#define LIGHT_SUMS_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) SIZE(lightTiles)

#define LIGHT_SUMS_PORTS(PORT, IMAGE, OUTPUT)                                                                                       \
  PORT(stopLuminance, READ,  FLOAT, QUELL_SIGNALS,                            ALL / QUELL_LIGHT_ROW_STEP,                   ALWAYS) \
  PORT(filtered,      READ,  FLOAT, 3 * QUELL_SIGNALS,                        ALL / QUELL_LIGHT_ROW_STEP,                   ALWAYS) \
  PORT(guides,        READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS),     PLANES(QUELL_SIGNALS) / QUELL_LIGHT_ROW_STEP, ALWAYS) \
  PORT(lightSums,     WRITE, FLOAT, RECORDS(QUELL_LIGHT_NUMBERS(lightTiles)), ELEMENTS(lightTiles * QUELL_LIGHT_RECORD),    ALWAYS)
// clang-format on

#endif
