#ifndef QUELL_COMMON_LUMINANCE_H
#define QUELL_COMMON_LUMINANCE_H

#include "common/lanes.h"

// Luminance of linear Rec. 709 RGB (ITU-R BT.709-6, item 3.2), numbers or vectors.
#define LUMINANCE_OF(red, green, blue) (0.2126f * (red) + 0.7152f * (green) + 0.0722f * (blue))

QUELL_INLINE floatL luminance(float3L rgb) { return LUMINANCE_OF(rgb.x, rgb.y, rgb.z); }

#endif
