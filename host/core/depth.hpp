// View depth from other kinds of depth: what kernels and tools compute it with.
#pragma once

#include <quell/frame.hpp>

namespace quell {

/// 1 / view depth = constant + slope * value, for the values of a depth buffer.
struct ReciprocalDepth {
  double constant = 0.0;  ///< per scene unit
  double slope = 0.0;
};

/// Of a perspective projection onto a depth buffer: hyperbolic or reversed. Planes in scene units, 0 < near < far.
inline ReciprocalDepth reciprocalDepth(DepthKind kind, double near, double far) {
  const double atNear = 1.0 / near, atFar = 1.0 / far;
  return kind == DepthKind::Reversed ? ReciprocalDepth{atFar, atNear - atFar}
                                     : ReciprocalDepth{atNear, atFar - atNear};
}

inline bool isDepthBuffer(DepthKind kind) {
  return kind == DepthKind::Hyperbolic || kind == DepthKind::Reversed;
}

}  // namespace quell
