// Ports of the stage guided_solve; see common/ports.h for the columns.
#ifndef QUELL_GUIDED_SOLVE_PORTS_H
#define QUELL_GUIDED_SOLVE_PORTS_H

#include "common/ports.h"
#include "guided_params.h"

// clang-format off
// QUELL_FEATURES is that of normal_equations.h.
#define GUIDED_SOLVE_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) OPTION(QUELL_FEATURES) SIZE(cellFloats) SIZE(cellCount)

#define GUIDED_SOLVE_PORTS(PORT, IMAGE, OUTPUT)                                                                       \
  PORT(windowMoments, READ,  FLOAT, RECORDS(cellFloats * QUELL_GUIDED_SUMS * QUELL_SIGNALS),         ELEMENTS(cellCount * QUELL_GUIDED_SUMS * QUELL_SIGNALS),         ALWAYS) \
  PORT(coefficients,  WRITE, FLOAT, RECORDS(cellFloats * QUELL_GUIDED_COEFFICIENTS * QUELL_SIGNALS), ELEMENTS(cellCount * QUELL_GUIDED_COEFFICIENTS * QUELL_SIGNALS), ALWAYS)
// clang-format on

#endif
