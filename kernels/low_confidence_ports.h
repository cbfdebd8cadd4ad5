// Ports of the stage low_confidence; see common/ports.h for the columns.
#ifndef QUELL_LOW_CONFIDENCE_PORTS_H
#define QUELL_LOW_CONFIDENCE_PORTS_H

#include "common/guides.h"
#include "common/ports.h"
#include "low_confidence_params.h"

// clang-format off
#define LOW_CONFIDENCE_OPTIONS(OPTION, SIZE) \
  OPTION(QUELL_SIGNALS) SIZE(cellFloats) SIZE(cellCount)

#define LOW_CONFIDENCE_PORTS(PORT, IMAGE, OUTPUT)                                                                \
  PORT(confidence,     READ,  FLOAT, QUELL_SIGNALS,                        PLANES(1),           ALWAYS) \
  PORT(guides,         READ,  FLOAT, QUELL_GUIDE_PLANES_OF(QUELL_SIGNALS), PLANES(1),           ALWAYS) \
  PORT(cellConfidence, WRITE, FLOAT, RECORDS(cellFloats),                  ELEMENTS(cellCount), ALWAYS)
// clang-format on

#endif
