// Parameters of the stage virtual_motion.
#ifndef QUELL_VIRTUAL_MOTION_PARAMS_H
#define QUELL_VIRTUAL_MOTION_PARAMS_H

#include "common/frame_image_params.h"
#include "common/reprojection_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct VirtualMotionParams {
  ReprojectionParams reprojection;
  PlaneParams planes;
  FrameImageParams images;
  QuellInt parallel;  // 1: all rays go along the view axis, 0: they begin at the camera
} VirtualMotionParams;

QUELL_NAMESPACE_END

#endif
