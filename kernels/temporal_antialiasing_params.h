// Parameters of the stage temporal_antialiasing.
#ifndef QUELL_TEMPORAL_ANTIALIASING_PARAMS_H
#define QUELL_TEMPORAL_ANTIALIASING_PARAMS_H

#include "common/frame_image_params.h"

QUELL_NAMESPACE_BEGIN

typedef struct TemporalAntialiasingParams {
  PlaneParams planes;
  OutputImageParams outputs;
  QuellFloat exposure;           // factor of radiance in the display image
  QuellFloat newestWeight;       // weight of the newest frame, (0, 1]
  QuellFloat silhouetteWeight;   // the same where surfaces clearly apart meet
  QuellFloat backgroundDepth;    // what pixels without a surface have as their view depth
  QuellInt antialiasBackground;  // whether background takes part, as it must where rays are jittered
} TemporalAntialiasingParams;

QUELL_NAMESPACE_END

// Share of a pixel's view depth below which a neighbour is in front of it: less is the slope of one surface.
#define QUELL_NEARER 0.97f
// Silhouettes are averaged over longer where that many of the 3x3 pixels met their own history, and where it was less
// than that many pixels away: after a cut, or fast as that, what lies there is something else. (docs/quell-sweep.md)
#define QUELL_STEADY_PIXELS 5
#define QUELL_STEADY_MOTION_PX 8.0f

#endif
