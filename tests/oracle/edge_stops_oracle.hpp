// Double-precision oracle of common/edge_stops.h and common/exponential.h: the penalties of a filter tap and e^-x.
#pragma once

#include "kernels/common/edge_stops_params.h"
#include "tests/support/planes.hpp"

namespace quell::tests {

/// What edge stops look at.
struct FilterGuides {
  Planes guides;     ///< of accumulate_noisy
  Planes viewDepth;  ///< 1 plane
  Planes roughness;  ///< 1 plane; empty: no stop at it
};

/// The stops of one centre pixel.
class EdgeStopsOracle {
 public:
  EdgeStopsOracle(const FilterGuides& guides, const EdgeStopParams& stops, int x, int y);

  /// Of depth and normal (Schied et al. 2017, eq. 3 and 4, with two terms of the logarithm); `distance` in pixels.
  double surfacePenalty(int x, int y, double distance) const;
  double roughnessPenalty(int x, int y) const;

 private:
  double depthSlope() const;
  double cosineTo(int x, int y) const;

  const FilterGuides& m_guides;
  const EdgeStopParams& m_stops;
  int m_x, m_y;
  double m_slope;
};

/// From here on a tap counts as 0 (common/exponential.h).
constexpr double kLargestPenalty = 9.0;

/// About e^-penalty, as common/exponential.h has it; 0 from kLargestPenalty on, and where it is NaN (background has neither depth nor slope).
double weightOfPenalty(double penalty);

/// Rec. 709.
double luminanceOf(double red, double green, double blue);

}  // namespace quell::tests
