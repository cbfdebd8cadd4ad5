// Inputs of the stage accumulate_noisy that its tests share.
#pragma once

#include "kernels/common/guides.h"
#include "tests/cases/accumulate_noisy_case.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {

const AccumulateNoisyVariant kPlain{kPlainMaterial};
const AccumulateNoisyVariant kPlainWithMoments{kPlainMaterial, false, true};
const AccumulateNoisyVariant kEverything{kTwoSignals, false, true, true, false, false, true};

// The camera stands still; the frame before showed the same surfaces.
inline void standStill(AccumulateNoisyCase& noisy, float historyLength) {
  noisy.useReprojection(makeReprojection({}, {}, noisy.size()));
  noisy.inputs.guidesPrev = renderScene({}, noisy.size()).guides;
  for (float& length : noisy.inputs.historyLengthPrev.values) length = historyLength;
}

inline bool isSurface(const Planes& guides, int x, int y) {
  return guides.at(QUELL_GUIDE_WEIGHT, x, y) > 0.0f;
}

}  // namespace quell::tests
