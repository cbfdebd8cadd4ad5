// compose: means over samples, and from them the picture that the camera sees.
// Paper:  none; color = albedo diffuse + tint glossy + emission, as `shade` splits the light.
// In:     feature images of `primary`, packed float3. In and out: sums of `shade`, which become means.
// Out:    radiance, packed float3.
#include "common/types.h"

__kernel void compose(__global const float* albedo, __global const float* glossColor,
                      __global const float* emission, __global float* diffuse, __global float* glossy,
                      __global float* color, int width, int height, float perSample) {
  const int x = (int)get_global_id(0);
  const int y = (int)get_global_id(1);
  if (x >= width || y >= height) return;
  const int pixel = y * width + x;
  const float3 diffuseMean = vload3(pixel, diffuse) * perSample;
  const float3 glossyMean = vload3(pixel, glossy) * perSample;
  vstore3(diffuseMean, pixel, diffuse);
  vstore3(glossyMean, pixel, glossy);
  vstore3(
      vload3(pixel, emission) + vload3(pixel, albedo) * diffuseMean + vload3(pixel, glossColor) * glossyMean,
      pixel, color);
}
