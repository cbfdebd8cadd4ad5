#include "tests/oracle/blended_sum_oracle.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/accumulate_noisy_params.h"

namespace quell::tests {
namespace {

// The two tiles of an axis between whose centres a pixel lies.
struct Neighbours {
  int before, after;
  double fraction;  // of the way from one to the other
};

// Tiles of one axis.
struct Axis {
  int offset, size, edge;

  double centre(int tile) const { return offset + (tile + 0.5) * edge; }

  // A tile whose centre lies outside the image is replaced by the nearest one inside, if there is one.
  Neighbours neighbours(int pixel) const {
    int first = 0, last = 0;
    while (offset + (last + 1) * edge < size) ++last;
    while (first < last && centre(first) < 0.0) ++first;
    while (first < last && centre(last) >= size) --last;
    const double position = (pixel + 0.5 - centre(0)) / edge;
    const int before = int(std::floor(position));
    return {std::clamp(before, first, last), std::clamp(before + 1, first, last), position - before};
  }
};

}  // namespace

BlendedSumExact blendedSumOracle(const BlendedSumInputs& inputs) {
  const Size size = inputs.guides.size();
  const Axis horizontal{inputs.params.tileOffsetX, size.width, inputs.tileEdge};
  const Axis vertical{inputs.params.tileOffsetY, size.height, inputs.tileEdge};
  BlendedSumExact exact{ExactPlanes(size, 3), ExactPlanes(size, 3)};
  forEachPixel(size, [&](int x, int y) {
    const Neighbours h = horizontal.neighbours(x), v = vertical.neighbours(y);
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero(), magnitude = sum;
    double total = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
      const bool right = corner % 2 == 1, below = corner / 2 == 1;
      const int column = right ? h.after : h.before, row = below ? v.after : v.before;
      const double share = (right ? h.fraction : 1.0 - h.fraction) * (below ? v.fraction : 1.0 - v.fraction);
      const FitRecord record = unpackRecord(inputs.records, row * inputs.params.tilesX + column, inputs.list);
      const Eigen::RowVectorXd t = features(inputs.guides, record, x, y);
      if (!record.usable) continue;  // a window without a sample
      sum += share * t * record.coefficients;
      magnitude += share * t.cwiseAbs() * record.coefficients.cwiseAbs();
      total += share;
    }
    if (isBackground(inputs.guides, x, y) || total == 0.0) return;
    sum /= total;
    magnitude /= total;
    for (int c = 0; c < 3; ++c) {
      exact.fitted.at(c, x, y) = std::clamp<double>(sum[c], 0.0, QUELL_MAX_RADIANCE);
      exact.magnitude.at(c, x, y) = magnitude[c];
    }
  });
  return exact;
}

}  // namespace quell::tests
