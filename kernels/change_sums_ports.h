// Ports of the stage change_sums; see common/ports.h for the columns.
#ifndef QUELL_CHANGE_SUMS_PORTS_H
#define QUELL_CHANGE_SUMS_PORTS_H

#include "change_params.h"
#include "common/innovation.h"
#include "common/ports.h"

// clang-format off
#define CHANGE_SUMS_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) SIZE(changeTiles)

#define CHANGE_SUMS_PORTS(PORT, IMAGE, OUTPUT)                                                   \
  PORT(innovation,     READ,     FLOAT, QUELL_INNOVATION_PLANES * QUELL_SIGNALS,   ALL, ALWAYS)  \
  PORT(historyLength,  READ,     UCHAR, QUELL_SIGNALS,                             ALL, ALWAYS)  \
  PORT(changeSumsPrev, PREVIOUS, FLOAT, RECORDS(changeTiles * QUELL_CHANGE_RECORD), ALL, ALWAYS) \
  PORT(changeSums,     WRITE,    FLOAT, RECORDS(changeTiles * QUELL_CHANGE_RECORD), ALL, ALWAYS)
// clang-format on

#endif
