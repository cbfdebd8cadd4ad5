// Where the caller's images of light and material lie.
#ifndef QUELL_COMMON_MATERIAL_PARAMS_H
#define QUELL_COMMON_MATERIAL_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct MaterialParams {
  QuellFloat4
      viewAxis;  // world space (.xyz); .w is 1 for an orthographic camera, else 0 and the axis is not used
  ImageViewParams radiance;
  ImageViewParams glossyRadiance;
  ImageViewParams emission;
  ImageViewParams albedo;
  ImageViewParams glossColor;
  ImageViewParams roughness;
  ImageViewParams f0;
} MaterialParams;

QUELL_NAMESPACE_END

#endif
