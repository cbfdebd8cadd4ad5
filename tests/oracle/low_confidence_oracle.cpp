#include "tests/oracle/low_confidence_oracle.hpp"

#include <algorithm>

namespace quell::tests {

ExactPlanes lowConfidenceOracle(const Planes& confidence, const Planes& weights) {
  const Size size = confidence.size();
  ExactPlanes cells(confidenceCellsOf(size), 1, 1.0);
  forEachPixel(size, [&](int x, int y) {
    double& least = cells.at(0, x / 16, y / 8);
    if (weights.at(0, x, y) > 0.0f) least = std::min<double>(least, confidence.at(0, x, y));
  });
  return cells;
}

}  // namespace quell::tests
