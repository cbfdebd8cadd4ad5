// Ports of the stage gram_solve; see common/ports.h for the columns.
#ifndef QUELL_GRAM_SOLVE_PORTS_H
#define QUELL_GRAM_SOLVE_PORTS_H

#include "common/ports.h"
#include "gram_params.h"

// clang-format off
#define GRAM_SOLVE_OPTIONS(OPTION, SIZE)                   \
  OPTION(GRAM_OVERLAP) SIZE(tileFloats) SIZE(recordFloats)

#define GRAM_SOLVE_PORTS(PORT, IMAGE, OUTPUT)                        \
  PORT(gramTiles,  READ,  FLOAT, RECORDS(tileFloats),   ALL, ALWAYS) \
  PORT(fitRecords, WRITE, FLOAT, RECORDS(recordFloats), ALL, ALWAYS)
// clang-format on

#endif
