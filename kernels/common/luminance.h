#ifndef QUELL_COMMON_LUMINANCE_H
#define QUELL_COMMON_LUMINANCE_H

#include "common/lanes.h"

// Luminance of linear Rec. 709 RGB (ITU-R BT.709-6, item 3.2).
QUELL_INLINE floatL luminance(float3L rgb) { return 0.2126f * rgb.x + 0.7152f * rgb.y + 0.0722f * rgb.z; }

#endif
