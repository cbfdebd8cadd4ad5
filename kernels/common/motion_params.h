// Where the caller's motion vectors and object ids lie.
#ifndef QUELL_COMMON_MOTION_PARAMS_H
#define QUELL_COMMON_MOTION_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct MotionParams {
  ImageViewParams motion;
  ImageViewParams objectId;
} MotionParams;

QUELL_NAMESPACE_END

#endif
