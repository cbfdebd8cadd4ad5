// import_image: one image of the caller into a packed buffer of floats, where what it holds is not what other stages read.
// Source:  ours; the reciprocal of a depth buffer's value is linear in 1 / depth for every perspective projection.
// In:      an image in the caller's layout or an OpenCL image object, of SOURCE_CHANNELS components.
// Out:     CHANNELS floats a pixel, row by row from the top: SUM divides sums by their counts, DEPTH makes view depth of other
//          kinds of it. A sum of no samples, and the depth of what is infinitely far, are not finite. With IDENTIFIERS one
//          word a pixel, the bits of an image object's first component.
// Simple loads on purpose: QUELL_LANES pixels a work-item only share its overhead.
#include "common/image_access.h"
#include "import_image_params.h"

#if SOURCE_FORMAT == QUELL_FORMAT_OBJECT
#define SOURCE_ARGUMENT __read_only image2d_t
__constant sampler_t kTexels = CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_NONE | CLK_FILTER_NEAREST;
#else
#define SOURCE_ARGUMENT __global const uchar*
#endif

#if IDENTIFIERS
typedef uint Imported;

// Integers of fewer bits are extended, as OpenCL does; a read of another kind than the texels is undefined.
QUELL_INLINE void importPixel(SOURCE_ARGUMENT source, __global Imported* pixel, ImportImageParams params,
                              int x, int y) {
  const int2 texel = (int2)(x, params.source.offset + y * params.source.rowPitch);
  const int type = get_image_channel_data_type(source);
  if (type == CLK_UNSIGNED_INT8 || type == CLK_UNSIGNED_INT16 || type == CLK_UNSIGNED_INT32)
    pixel[0] = read_imageui(source, kTexels, texel).x;
  else if (type == CLK_SIGNED_INT8 || type == CLK_SIGNED_INT16 || type == CLK_SIGNED_INT32)
    pixel[0] = as_uint(read_imagei(source, kTexels, texel).x);
  else
    pixel[0] = as_uint(read_imagef(source, kTexels, texel).x);
}
#else
typedef float Imported;

#if SOURCE_FORMAT == QUELL_FORMAT_OBJECT
QUELL_INLINE float4 loadSource(__read_only image2d_t source, ImageViewParams view, int x, int y) {
  return read_imagef(source, kTexels, (int2)(x, view.offset + y * view.rowPitch));
}
#else
QUELL_INLINE float4 loadSource(__global const uchar* source, ImageViewParams view, int x, int y) {
  const size_t first = pixelComponent(view, x, y, SOURCE_STRIDE);
  float4 value = (float4)(loadComponent(source, first, SOURCE_FORMAT), 0.0f, 0.0f, 0.0f);
  if (SOURCE_CHANNELS > 1) value.y = loadComponent(source, first + 1, SOURCE_FORMAT);
  if (SOURCE_CHANNELS > 2) value.z = loadComponent(source, first + 2, SOURCE_FORMAT);
  if (SOURCE_CHANNELS > 3) value.w = loadComponent(source, first + 3, SOURCE_FORMAT);
  return value;
}
#endif

QUELL_INLINE float4 meanOf(float4 sum, float sampleCount) {
#if SUM == QUELL_SUM_COUNT_IN_FOURTH
  return sum / sum.w;
#elif SUM == QUELL_SUM_OVER_SAMPLE_COUNT
  return sum / sampleCount;
#else
  return sum;
#endif
}

QUELL_INLINE float toViewDepth(float value, ImportImageParams params, int x, int y) {
#if DEPTH == QUELL_DEPTH_ALONG_RAY
  const float4 ray = (float)x * params.rayX + (float)y * params.rayY + params.rayOrigin;
  return value / sqrt(ray.x * ray.x + ray.y * ray.y + ray.z * ray.z);
#elif DEPTH == QUELL_DEPTH_RECIPROCAL
  return 1.0f / (params.depthConstant + params.depthSlope * value);
#elif DEPTH == QUELL_DEPTH_NEGATED
  return -value;
#else
  return value;
#endif
}

QUELL_INLINE void importPixel(SOURCE_ARGUMENT source, __global Imported* pixel, ImportImageParams params,
                              int x, int y) {
  const float4 value = meanOf(loadSource(source, params.source, x, y), params.sampleCount);
  pixel[0] = toViewDepth(value.x, params, x, y);
  if (CHANNELS > 1) pixel[1] = value.y;
  if (CHANNELS > 2) pixel[2] = value.z;
}
#endif

__kernel void import_image(SOURCE_ARGUMENT source, __global Imported* imported, ImportImageParams params) {
  const int first = (int)get_global_id(0) * QUELL_LANES;
  const int y = (int)get_global_id(1);
  if (y >= params.height) return;
  for (int x = first; x < min(first + QUELL_LANES, params.width); ++x)
    importPixel(source, imported + ((size_t)y * (size_t)params.width + (size_t)x) * CHANNELS, params, x, y);
}
