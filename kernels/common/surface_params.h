// Where the caller's images of a surface lie.
#ifndef QUELL_COMMON_SURFACE_PARAMS_H
#define QUELL_COMMON_SURFACE_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct SurfaceParams {
  ImageViewParams normal;
  ImageViewParams position;  // or view depth
} SurfaceParams;

QUELL_NAMESPACE_END

#endif
