#include "tests/oracle/accumulate_filtered_oracle.hpp"

#include <algorithm>

#include "kernels/accumulate_noisy_params.h"
#include "tests/oracle/bilinear_oracle.hpp"

namespace quell::tests {

ExactPlanes accumulateFilteredOracle(const AccumulateFilteredInputs& inputs) {
  const Size size = inputs.fitted.size();
  ExactPlanes filtered(size, 3);
  forEachPixel(size, [&](int x, int y) {
    const int mask = int(inputs.reprojectionMask.at(0, x, y));
    double sum[3] = {}, weightSum = 0.0;
    for (const Tap& tap : bilinearTaps(size, inputs.pixelPrev.at(0, x, y), inputs.pixelPrev.at(1, x, y))) {
      if ((mask & QUELL_TAP_ACCEPTED(tap.index)) == 0) continue;
      for (int c = 0; c < 3; ++c) sum[c] += tap.weight * inputs.filteredPrev.at(c, tap.x, tap.y);
      weightSum += tap.weight;
    }
    const double cumulative = 1.0 / std::max(1.0, double(inputs.historyLength.at(0, x, y)));
    const double blend = weightSum > 0.0 ? std::max(cumulative, inputs.leastWeight) : 1.0;
    for (int c = 0; c < 3; ++c) {
      const double history = weightSum > 0.0 ? sum[c] / weightSum : 0.0;
      filtered.at(c, x, y) = blend * inputs.fitted.at(c, x, y) + (1.0 - blend) * history;
    }
  });
  return filtered;
}

}  // namespace quell::tests
