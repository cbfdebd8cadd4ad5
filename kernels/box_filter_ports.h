// Ports of the stage box_filter; see common/ports.h for the columns.
#ifndef QUELL_BOX_FILTER_PORTS_H
#define QUELL_BOX_FILTER_PORTS_H

#include "box_filter_params.h"
#include "common/ports.h"

// clang-format off
#define BOX_FILTER_OPTIONS(OPTION, SIZE) \
  OPTION(BOX_MINIMA) SIZE(boxFloats) SIZE(boxElements)

#define BOX_FILTER_PORTS(PORT, IMAGE, OUTPUT)                 \
  PORT(boxInput, READ,  FLOAT, RECORDS(boxFloats), ELEMENTS(boxElements), ALWAYS) \
  PORT(boxOutput,  WRITE, FLOAT, RECORDS(boxFloats), ELEMENTS(boxElements), ALWAYS)
// clang-format on

#endif
