#include "tests/oracle/material_guides_oracle.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/fit_params.h"

namespace quell::tests {
namespace {

double clean(float value) { return std::isfinite(value) ? std::clamp(double(value), 0.0, 1.0) : 0.0; }

}  // namespace

ExactPlanes materialGuidesOracle(const MaterialGuidesInputs& inputs) {
  const Size size = {inputs.roughness.width, inputs.roughness.height};
  ExactPlanes exact(size, QUELL_MATERIAL_PLANES);
  forEachPixel(size, [&](int x, int y) {
    // One channel is spread over all three.
    for (int c = 0; c < 3; ++c)
      exact.at(QUELL_MATERIAL_ALBEDO + c, x, y) =
          clean(inputs.albedo.at(x, y, inputs.albedo.channels == 1 ? 0 : c));
    exact.at(QUELL_MATERIAL_ROUGHNESS, x, y) = clean(inputs.roughness.at(x, y, 0));
  });
  return exact;
}

}  // namespace quell::tests
