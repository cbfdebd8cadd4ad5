#include "tests/oracle/remodulate_oracle.hpp"

#include <algorithm>

#include "kernels/accumulate_noisy_params.h"

namespace quell::tests {
namespace {

bool isSurface(const Planes& guides, int x, int y) {
  for (int axis = 0; axis < 3; ++axis)
    if (guides.at(QUELL_GUIDE_NORMAL + axis, x, y) != 0.0f) return true;
  return false;
}

struct Remodulated {
  Vector3d linear;
  double magnitude;
};

Remodulated remodulate(const Material& material, bool demodulated, bool surface, const Vector3d& filtered) {
  const Vector3d signal =
      demodulated ? Vector3d(material.signal.cwiseProduct(material.factor)) : material.signal;
  const Vector3d product = material.factor.cwiseProduct(filtered);
  Vector3d share = demodulated ? Vector3d::Ones() : filteredShare(material.factor);
  if (!surface) share.setZero();
  const Vector3d light = share.cwiseProduct(product) + (Vector3d::Ones() - share).cwiseProduct(signal);
  const Vector3d sum = light + material.emission;
  return {sum.cwiseMax(0.0).cwiseMin(QUELL_MAX_RADIANCE),
          std::max({signal.maxCoeff(), product.maxCoeff(), material.emission.cwiseAbs().maxCoeff()})};
}

}  // namespace

RemodulateExact remodulateOracle(const RemodulateInputs& inputs) {
  const Size size = inputs.filtered.size();
  RemodulateExact exact{ExactPlanes(size, 3), ExactPlanes(size, 1), BasicPlanes<char>(size, 1)};
  forEachPixel(size, [&](int x, int y) {
    const Material material = materialAt(inputs.material, x, y);
    const Vector3d filtered(inputs.filtered.at(0, x, y), inputs.filtered.at(1, x, y),
                            inputs.filtered.at(2, x, y));
    const Remodulated result =
        remodulate(material, inputs.material.demodulated, isSurface(inputs.guides, x, y), filtered);
    for (int c = 0; c < 3; ++c) exact.linear.at(c, x, y) = result.linear[c];
    exact.magnitude.at(0, x, y) = result.magnitude;
    exact.undecided.at(0, x, y) = factorUndecided(material);
  });
  return exact;
}

}  // namespace quell::tests
