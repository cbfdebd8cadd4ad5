// virtual_motion: where what is seen in a mirror was in the frame before.
// Paper:   Mara et al. 2017, stage 8, after Zimmer et al. 2015: a reflection moves as the virtual point does that lies behind
//          the surface, as far along the ray as what was hit lies in front of it.
// In:      hit distance of the glossy signal, guides of this frame (position, normal) and of the one before (normal, weight
//          of the last signal), and the motion and accepted taps of the surface.
// Out:     virtual position (3 planes, relative to the camera), the pixel index of it in the frame before (2 planes) and the
//          accepted taps there (bytes, see common/guides.h); those of the surface where the hit distance is not known.
// Border:  taps outside the image are not accepted.
// Departures: surfaces count as flat; a tap is accepted by its normal, and by the positions in soft_history.
#include "common/frame_images.h"
#include "common/guides.h"
#include "common/reprojection.h"
#include "common/surfaces.h"
#include "virtual_motion_ports.h"

// Which of the taps show a surface with this normal that had a sample.
QUELL_INLINE intL acceptTaps(__global const float* previous, VirtualMotionParams params, Surface surface,
                             BilinearTaps taps) {
  const int stride = params.planes.stride;
  intL mask = (intL)(0);
  for (int i = 0; i < 4; ++i) {
    const int offset = tapOffset(params.planes, i);
    const float3L normal = gatherLanes3(previous + QUELL_GUIDE_NORMAL * stride + offset, taps.plan, stride);
    const floatL weight =
        gatherLanes(previous + (QUELL_GUIDE_WEIGHT + QUELL_SIGNALS - 1) * stride + offset, taps.plan);
    const intL accepted = taps.inFrame[i] && weight > 0.0f && taps.weight[i] > 0.0f &&
                          sameNormal(params.reprojection, surface, normal);
    mask = mask | (accepted ? (intL)(QUELL_TAP_ACCEPTED(i)) : (intL)(0));
  }
  return mask;
}

__kernel void virtual_motion(STAGE_ARGUMENTS(VIRTUAL_MOTION) VirtualMotionParams params) {
  BEGIN_PIXELS(params.planes);
  LEAVE_OUT_BACKGROUND(storeByteLanes((intL)(0), virtualMask + index))
  BIND_FRAME_IMAGES(VIRTUAL_MOTION, params.images);
  const int lanes = min(QUELL_LANES, planes.width - x);
  Surface surface;
  surface.position = loadLanes3(guides + QUELL_GUIDE_POSITION * stride, index, stride);
  surface.normal = loadLanes3(guides + QUELL_GUIDE_NORMAL * stride, index, stride);
  surface.valid = dot3(surface.normal, surface.normal) > 0.0f;

  const floatL hit = LOAD_IMAGE(hitDistance, HITDISTANCE, x, y, lanes).x;
  const floatL distance = SQRT(dot3(surface.position, surface.position));
  float3L along = scale3(surface.position, 1.0f / (distance > 0.0f ? distance : ONE_LANES));
  if (params.parallel) {
    along.x = (floatL)(params.reprojection.viewDepth.x);
    along.y = (floatL)(params.reprojection.viewDepth.y);
    along.z = (floatL)(params.reprojection.viewDepth.z);
  }
  // What is not known, or nearly at infinity, leaves the surface's own.
  const intL known = isFinite(hit) && hit > 0.0f && hit < QUELL_MAX_POSITION && surface.valid;
  const float3L position =
      select3(known, add3(surface.position, scale3(along, known ? hit : ZERO_LANES)), surface.position);
  floatL xPrev, yPrev;
  const intL inside = reproject(params.reprojection, position, (intL)(0), TO_FLOAT(x + LANE_INDEX),
                                (floatL)((float)y), planes.width, planes.height, &xPrev, &yPrev);
  const intL moved = known && inside;
  xPrev = known ? xPrev : loadLanes(pixelPrev + index);
  yPrev = known ? yPrev : loadLanes(pixelPrev + index + stride);
  const BilinearTaps taps = bilinearTaps(planes, xPrev, yPrev);
  const intL accepted = moved ? acceptTaps(guidesPrev, params, surface, taps) : (intL)(0);
  const intL ofSurface = loadByteLanes(reprojectionMask + (QUELL_SIGNALS - 1) * stride + index);
  storeLanes3(position, virtualPositions, index, stride);
  storeLanes(xPrev, virtualPixelPrev + index);
  storeLanes(yPrev, virtualPixelPrev + index + stride);
  storeByteLanes(known ? accepted : ofSurface, virtualMask + index);
}
