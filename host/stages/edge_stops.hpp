// Settings of the edge stops that the stages variance and atrous share.
#pragma once

#include "kernels/common/edge_stops_params.h"

namespace quell {

struct EdgeStops {
  double normalPower = 128.0;   ///< of the cosine between normals, >= 1
  double depthSigma = 1.0;      ///< in steps of the depth's slope, > 0
  double roughnessSigma = 0.0;  ///< relative difference of roughness; 0: no such stop
};

inline EdgeStopParams makeEdgeStopParams(const EdgeStops& stops) {
  EdgeStopParams params{};
  params.normalPower = static_cast<float>(stops.normalPower);
  params.inverseDepth = static_cast<float>(1.0 / stops.depthSigma);
  params.inverseRoughness =
      stops.roughnessSigma > 0.0 ? static_cast<float>(1.0 / stops.roughnessSigma) : 0.0f;
  return params;
}

}  // namespace quell
