#include "tests/oracle/edge_stops_oracle.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/common/guides.h"

namespace quell::tests {
namespace {

// The smaller one-sided difference along an axis; 0 where the image is one pixel wide.
double slopeAlong(const Planes& depth, int x, int y, int dx, int dy) {
  const auto has = [&](int column, int row) {
    return column >= 0 && column < depth.width && row >= 0 && row < depth.height;
  };
  const auto step = [&](int sign) {
    return std::abs(double(depth.at(0, x + sign * dx, y + sign * dy)) - depth.at(0, x, y));
  };
  const bool before = has(x - dx, y - dy), after = has(x + dx, y + dy);
  if (before && after) return std::min(step(-1), step(1));
  return before ? step(-1) : after ? step(1) : 0.0;
}

}  // namespace

EdgeStopsOracle::EdgeStopsOracle(const FilterGuides& guides, const EdgeStopParams& stops, int x, int y)
    : m_guides(guides), m_stops(stops), m_x(x), m_y(y), m_slope(depthSlope()) {}

double EdgeStopsOracle::depthSlope() const {
  const Planes& depth = m_guides.viewDepth;
  const double slope = std::max(slopeAlong(depth, m_x, m_y, 1, 0), slopeAlong(depth, m_x, m_y, 0, 1));
  return slope + double(QUELL_LEAST_SLOPE) * std::abs(depth.at(0, m_x, m_y));
}

double EdgeStopsOracle::cosineTo(int x, int y) const {
  double cosine = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    cosine += double(m_guides.guides.at(QUELL_GUIDE_NORMAL + axis, m_x, m_y)) *
              m_guides.guides.at(QUELL_GUIDE_NORMAL + axis, x, y);
  return cosine;
}

double EdgeStopsOracle::surfacePenalty(int x, int y, double distance) const {
  const double depthStep =
      std::abs(double(m_guides.viewDepth.at(0, x, y)) - m_guides.viewDepth.at(0, m_x, m_y));
  const double fromOne = 1.0 - cosineTo(x, y);
  return m_stops.normalPower * (fromOne + fromOne * fromOne / 2.0) +
         depthStep * m_stops.inverseDepth / (m_slope * distance);
}

double EdgeStopsOracle::roughnessPenalty(int x, int y) const {
  if (m_guides.roughness.count == 0) return 0.0;
  const double centre = m_guides.roughness.at(0, m_x, m_y);
  const double unit = std::max<double>(centre, QUELL_LEAST_ROUGHNESS);
  return std::abs(m_guides.roughness.at(0, x, y) - centre) * m_stops.inverseRoughness / unit;
}

double weightOfPenalty(double penalty) {
  return penalty < kLargestPenalty ? std::pow(1.0 - penalty / kLargestPenalty, 8) : 0.0;
}

double luminanceOf(double red, double green, double blue) {
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

}  // namespace quell::tests
