// Parameters of the stage remodulate.
#ifndef QUELL_REMODULATE_PARAMS_H
#define QUELL_REMODULATE_PARAMS_H

#include "common/frame_image_params.h"

QUELL_NAMESPACE_BEGIN

typedef struct RemodulateParams {
  PlaneParams planes;
  FrameImageParams images;
  OutputImageParams outputs;
  QuellFloat exposure;  // factor of radiance in the display image
  QuellInt tilesX;      // of the gains of light_gain
  QuellInt tilesY;
} RemodulateParams;

QUELL_NAMESPACE_END

#endif
