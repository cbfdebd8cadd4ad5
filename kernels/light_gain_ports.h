// Ports of the stage light_gain; see common/ports.h for the columns.
#ifndef QUELL_LIGHT_GAIN_PORTS_H
#define QUELL_LIGHT_GAIN_PORTS_H

#include "common/ports.h"
#include "light_params.h"

// clang-format off
#define LIGHT_GAIN_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) SIZE(lightTiles)

#define LIGHT_GAIN_PORTS(PORT, IMAGE, OUTPUT)                                                                               \
  PORT(lightSums, READ,  FLOAT, RECORDS(QUELL_LIGHT_NUMBERS(lightTiles)), ELEMENTS(lightTiles * QUELL_LIGHT_RECORD), ALWAYS) \
  PORT(lightGain, WRITE, FLOAT, RECORDS(lightTiles),                      ALL,                                       ALWAYS)
// clang-format on

#endif
