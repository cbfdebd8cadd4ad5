// Parameters of the stage import_image.
#ifndef QUELL_IMPORT_IMAGE_PARAMS_H
#define QUELL_IMPORT_IMAGE_PARAMS_H

#include "common/types.h"

// Values of the compile option SUM, as quell::Sum.
#define QUELL_SUM_NONE 0
#define QUELL_SUM_COUNT_IN_FOURTH 1
#define QUELL_SUM_OVER_SAMPLE_COUNT 2

// Values of the compile option DEPTH.
#define QUELL_DEPTH_AS_IT_IS 0    // also of what is not a depth
#define QUELL_DEPTH_ALONG_RAY 1   // a distance along the pixel's ray
#define QUELL_DEPTH_RECIPROCAL 2  // 1 / (depthConstant + depthSlope * value)
#define QUELL_DEPTH_NEGATED 3

QUELL_NAMESPACE_BEGIN

typedef struct ImportImageParams {
  // The point at view depth 1 of pixel (x, y), as in ReprojectionParams.
  QuellFloat4 rayX;
  QuellFloat4 rayY;
  QuellFloat4 rayOrigin;
  QuellInt width;  // pixels
  QuellInt height;
  ImageViewParams source;
  QuellFloat sampleCount;
  QuellFloat depthConstant;  // per scene unit
  QuellFloat depthSlope;
} ImportImageParams;

QUELL_NAMESPACE_END

#endif
