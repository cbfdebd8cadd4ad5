// median_filter: the median of 3x3 pixels, of each channel by itself.
// Paper:   Mara et al. 2017, stage 6: takes fireflies from the picture; outside of the loop of the history, whose mean they
//          stay part of. The network of comparisons is that of Smith 1996 for nine numbers.
// In:      irradiance (of the first signal, 3 planes), guides (the weights alone). Out: its median.
// Border:  in place of pixels outside the image and of those without a sample stands the centre.
#include "common/surfaces.h"
#include "median_filter_ports.h"

QUELL_INLINE void sortPair(floatL* low, floatL* high) {
  const floatL smaller = minLanes(*low, *high);
  *high = maxLanes(*low, *high);
  *low = smaller;
}

QUELL_INLINE floatL medianOfNine(floatL* v) {
  sortPair(v + 1, v + 2), sortPair(v + 4, v + 5), sortPair(v + 7, v + 8);
  sortPair(v + 0, v + 1), sortPair(v + 3, v + 4), sortPair(v + 6, v + 7);
  sortPair(v + 1, v + 2), sortPair(v + 4, v + 5), sortPair(v + 7, v + 8);
  sortPair(v + 0, v + 3), sortPair(v + 5, v + 8), sortPair(v + 4, v + 7);
  sortPair(v + 3, v + 6), sortPair(v + 1, v + 4), sortPair(v + 2, v + 5);
  sortPair(v + 4, v + 7), sortPair(v + 4, v + 2), sortPair(v + 6, v + 4);
  sortPair(v + 4, v + 2);
  return v[4];
}

__kernel void median_filter(STAGE_ARGUMENTS(MEDIAN_FILTER) MedianFilterParams params) {
  BEGIN_PIXELS(params.planes);
  LEAVE_OUT_BACKGROUND(NOTHING_ELSE)
  __global const float* weights = guides + QUELL_GUIDE_WEIGHT * stride;
  for (int c = 0; c < 3; ++c) {
    __global const float* plane = medianInput + c * stride;
    const floatL centre = loadLanes(plane + index);
    floatL values[9];
    UNROLL_ON_GPU
    for (int i = 0; i < 9; ++i) {
      const int dx = i % 3 - 1;
      const int dy = i / 3 - 1;
      const int at = index + dy * planes.pitch + dx;
      const intL counts =
          insideFrame(planes, x + dx + LANE_INDEX, (intL)(y + dy)) && loadLanes(weights + at) > 0.0f;
      values[i] = counts ? loadLanes(plane + at) : centre;
    }
    storeLanes(medianOfNine(values), medianOutput + c * stride + index);
  }
}
