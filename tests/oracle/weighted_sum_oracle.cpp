#include "tests/oracle/weighted_sum_oracle.hpp"

#include <algorithm>

#include "kernels/accumulate_noisy_params.h"

namespace quell::tests {

WeightedSumExact weightedSumOracle(const WeightedSumInputs& inputs) {
  const Size size = inputs.guides.size();
  WeightedSumExact exact{ExactPlanes(size, 3), ExactPlanes(size, 3)};
  forEachPixel(size, [&](int x, int y) {
    const int block = (y - inputs.params.blockOffsetY) / QUELL_BLOCK_EDGE * inputs.params.blocksX +
                      (x - inputs.params.blockOffsetX) / QUELL_BLOCK_EDGE;
    const FitRecord record = unpackRecord(inputs.records, block, inputs.list);
    if (isBackground(inputs.guides, x, y)) return;
    const Eigen::RowVectorXd t = features(inputs.guides, record, x, y);
    const Eigen::RowVector3d sum = t * record.coefficients;
    const Eigen::RowVector3d magnitude = t.cwiseAbs() * record.coefficients.cwiseAbs();
    for (int c = 0; c < 3; ++c) {
      exact.fitted.at(c, x, y) = std::clamp<double>(sum[c], 0.0, QUELL_MAX_RADIANCE);
      exact.magnitude.at(c, x, y) = magnitude[c];
    }
  });
  return exact;
}

}  // namespace quell::tests
