// Where the caller's images of light and material lie.
#ifndef QUELL_COMMON_MATERIAL_PARAMS_H
#define QUELL_COMMON_MATERIAL_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct MaterialParams {
  ImageViewParams radiance;
  ImageViewParams glossyRadiance;
  ImageViewParams emission;
  ImageViewParams albedo;
  ImageViewParams glossColor;
} MaterialParams;

QUELL_NAMESPACE_END

#endif
