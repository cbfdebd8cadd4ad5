// Ports of the stages that divide light by F_beta, or multiply with it; see common/ports.h for the columns.
#ifndef QUELL_COMMON_F_BETA_PORTS_H
#define QUELL_COMMON_F_BETA_PORTS_H

#include "common/ports.h"
#include "f_beta_table_params.h"

// clang-format off
// What F_beta is looked up with, beside the image roughness. F0 counts without F_beta as well.
#define F_BETA_PORTS(PORT, IMAGE)                                                                             \
  IMAGE(f0, F0, SURFACES, DEMODULATE == QUELL_DEMODULATE_F_BETA || F0_DIMS_GLOSS)                             \
  PORT(fBetaTable, TABLE, FLOAT4, RECORDS(QUELL_F_BETA_EDGE * QUELL_F_BETA_EDGE), LOOKED_UP,                  \
       DEMODULATE == QUELL_DEMODULATE_F_BETA)

// Only the first stage of a frame looks F_beta up; these planes keep it for the last.
#define F_BETA_KEPT_PORT(PORT, access, touched) \
  PORT(fBeta, access, FLOAT, 3, touched, DEMODULATE == QUELL_DEMODULATE_F_BETA)
// clang-format on

#endif
