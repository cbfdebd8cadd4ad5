// Ports of the stage material_guides; see common/ports.h for the columns.
#ifndef QUELL_MATERIAL_GUIDES_PORTS_H
#define QUELL_MATERIAL_GUIDES_PORTS_H

#include "common/ports.h"
#include "fit_params.h"
#include "material_guides_params.h"

// clang-format off
#define MATERIAL_GUIDES_OPTIONS(OPTION, SIZE) \
  OPTION(USES_ALBEDO) OPTION(USES_ROUGHNESS)

#define MATERIAL_GUIDES_PORTS(PORT, IMAGE, OUTPUT)                                                       \
  IMAGE(albedo, ALBEDO, 1, USES_ALBEDO)                                                                  \
  IMAGE(roughness, ROUGHNESS, 1, USES_ROUGHNESS)                                                         \
  PORT(materials, WRITE, FLOAT, QUELL_MATERIAL_PLANES, PLANES(3 * USES_ALBEDO + USES_ROUGHNESS), ALWAYS)
// clang-format on

#endif
