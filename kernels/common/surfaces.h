// Which work-items show nothing but background, so that stages can leave them out. Compiled in with SKIP.
//
// `surfaces` has one byte a work-item of the per-pixel kernels, QUELL_LANES pixels of a row: 0 where the first stage of a
// frame found nothing but background in them. What it writes there is the least that others look at: weight, history
// length, view depth; with motion vectors normals; where background is antialiased where it was. Everything else keeps
// finite values of earlier frames, which count for nothing. A stage that leaves out background has the port `surfaces`
// (SURFACES_PORT) and begins with LEAVE_OUT_BACKGROUND, or asks isFarBackground(); what background has to hold for it
// nevertheless is said there.
#ifndef QUELL_COMMON_SURFACES_H
#define QUELL_COMMON_SURFACES_H

#include "common/lanes.h"
#include "common/planes.h"
#include "common/types.h"

// Element of `surfaces` of the work-item at pixel (x, y).
QUELL_INLINE int surfaceIndex(PlaneParams planes, int x, int y) {
  return y * ((planes.width + QUELL_LANES - 1) / QUELL_LANES) + x / QUELL_LANES;
}

// Returns where the work-item shows nothing but background, after `statement`.
#define LEAVE_OUT_BACKGROUND(statement)               \
  if (SKIP && isBackground(surfaces, planes, x, y)) { \
    statement;                                        \
    return;                                           \
  }
#define NOTHING_ELSE

// A statement for LEAVE_OUT_BACKGROUND: background next to surfaces, which their 3x3 neighbourhoods reach, is 0 in the
// planes `name`.
#define ZERO_NEXT_TO_SURFACES(name, planeCount)              \
  if (isNearSurface(surfaces, planes, x, y)) {               \
    for (int plane = 0; plane < (planeCount); ++plane)       \
      storeLanes(ZERO_LANES, name + plane * stride + index); \
  }

QUELL_INLINE int isBackground(__global const uchar* surfaces, PlaneParams planes, int x, int y) {
  return surfaces[surfaceIndex(planes, x, y)] == 0;
}

// Whether a work-item with a surface is next to this one: then its 3x3 neighbourhoods reach into this one's pixels.
QUELL_INLINE int isNearSurface(__global const uchar* surfaces, PlaneParams planes, int x, int y) {
  const int columns = (planes.width + QUELL_LANES - 1) / QUELL_LANES;
  if (x >= QUELL_LANES && x + QUELL_LANES < planes.width && y > 0 && y + 1 < planes.height) {
    __global const uchar* left = surfaces + surfaceIndex(planes, x, y) - 1;
    const uchar3 found = vload3(0, left - columns) | vload3(0, left) | vload3(0, left + columns);
    return found.x | found.y | found.z;
  }
  int found = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int column = clamp(x + dx * QUELL_LANES, 0, planes.width - 1);
      const int row = clamp(y + dy, 0, planes.height - 1);
      found |= surfaces[surfaceIndex(planes, column, row)];
    }
  }
  return found;
}

// Whether a work-item is left out by a stage that works on background next to surfaces as well.
QUELL_INLINE int isFarBackground(__global const uchar* surfaces, PlaneParams planes, int x, int y) {
  return isBackground(surfaces, planes, x, y) && !isNearSurface(surfaces, planes, x, y);
}

// Whether a work-item with a surface is among the pixels from (left, top) to (right, bottom), both included, as far as
// they are in the image.
QUELL_INLINE int anySurface(__global const uchar* surfaces, PlaneParams planes, int left, int top, int right,
                            int bottom) {
  const int columns = (planes.width + QUELL_LANES - 1) / QUELL_LANES;
  const int first = max(left, 0) / QUELL_LANES;
  const int last = min(right, planes.width - 1) / QUELL_LANES;
  int found = 0;
  for (int row = max(top, 0); row <= min(bottom, planes.height - 1); ++row)
    for (int column = first; column <= last; ++column) found |= surfaces[row * columns + column];
  return found;
}

#endif
