// Ports of the stage change_weight; see common/ports.h for the columns.
#ifndef QUELL_CHANGE_WEIGHT_PORTS_H
#define QUELL_CHANGE_WEIGHT_PORTS_H

#include "change_params.h"
#include "common/ports.h"

// clang-format off
#define CHANGE_WEIGHT_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) SIZE(changeTiles)

#define CHANGE_WEIGHT_PORTS(PORT, IMAGE, OUTPUT)                                                   \
  PORT(changeSums,       READ,     FLOAT, RECORDS(changeTiles * QUELL_CHANGE_RECORD), ALL, ALWAYS) \
  PORT(recentChangePrev, PREVIOUS, FLOAT, RECORDS(changeTiles),                      ALL, ALWAYS)  \
  PORT(recentChange,     WRITE,    FLOAT, RECORDS(changeTiles),                      ALL, ALWAYS)  \
  PORT(changeWeights,    WRITE,    FLOAT, RECORDS(changeTiles),                      ALL, ALWAYS)
// clang-format on

#endif
