// Where the caller's images lie, all of them: kernels take what they need.
#ifndef QUELL_COMMON_FRAME_IMAGE_PARAMS_H
#define QUELL_COMMON_FRAME_IMAGE_PARAMS_H

#include "common/types.h"
#include "quell/frame_images.h"

QUELL_NAMESPACE_BEGIN

#define QUELL_IMAGE_PARAMS(name, NAME, least, most, kind, presence, files, texts) ImageViewParams name;

typedef struct FrameImageParams {
  QUELL_FRAME_IMAGES(QUELL_IMAGE_PARAMS)
} FrameImageParams;

typedef struct OutputImageParams {
  QUELL_OUTPUT_IMAGES(QUELL_IMAGE_PARAMS)
} OutputImageParams;

QUELL_NAMESPACE_END

#endif
