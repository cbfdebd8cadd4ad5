// How much a difference in depth, normal, roughness or luminance lowers the weight of a filter tap.
#ifndef QUELL_COMMON_EDGE_STOPS_PARAMS_H
#define QUELL_COMMON_EDGE_STOPS_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct EdgeStopParams {
  QuellFloat normalPower;       // of the cosine between the normals, 1 to 1024
  QuellFloat inverseDepth;      // 1 / sigma_z
  QuellFloat inverseRoughness;  // 1 / sigma_r; 0: no such stop
} EdgeStopParams;

QUELL_NAMESPACE_END

// Least slope of a surface, as a share of the view depth per pixel: about 2.4 degrees at 480 pixels and 60 degrees
// across.
#define QUELL_LEAST_SLOPE 1e-4f
// Roughness below this counts as this: mirrors of slightly different roughness look alike.
#define QUELL_LEAST_ROUGHNESS 0.02f

#endif
