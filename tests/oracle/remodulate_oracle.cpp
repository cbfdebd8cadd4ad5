#include "tests/oracle/remodulate_oracle.hpp"

#include <algorithm>

#include "kernels/accumulate_noisy_params.h"
#include "tests/oracle/display_encoding_oracle.hpp"
#include "tests/oracle/edge_stops_oracle.hpp"
#include "tests/oracle/light_gain_oracle.hpp"

namespace quell::tests {
namespace {

bool isSurface(const Planes& guides, int x, int y) {
  for (int axis = 0; axis < 3; ++axis)
    if (guides.at(QUELL_GUIDE_NORMAL + axis, x, y) != 0.0f) return true;
  return false;
}

// Radiance of one signal, and the largest of its terms.
struct Remodulated {
  Vector3d light;
  double magnitude;
};

Remodulated remodulate(const Material& material, bool isFiltered, const Vector3d& filtered) {
  const Vector3d product = material.divisor.cwiseProduct(filtered);
  Vector3d light = isFiltered ? product : material.signal;
  for (std::size_t c = 0; c < 3; ++c)
    if (material.fillsWeak && material.weak[c]) light[Eigen::Index(c)] = material.signal[Eigen::Index(c)];
  return {material.tint.cwiseProduct(light),
          material.tint.maxCoeff() * std::max(material.signal.maxCoeff(), product.maxCoeff())};
}

Vector3d filteredAt(const RemodulateInputs& inputs, int x, int y, int signal) {
  const auto channel = [&](int c) { return double(inputs.filtered.at(3 * signal + c, x, y)); };
  const Vector3d filtered(channel(0), channel(1), channel(2));
  if (inputs.lightGain.count == 0) return filtered;
  const double gain = betweenTiles(inputs.lightGain, TileGrid(inputs.filtered.size()), signal, x, y);
  return lightRatio(gain, luminanceOf(filtered[0], filtered[1], filtered[2])) * filtered;
}

}  // namespace

RemodulateExact remodulateOracle(const RemodulateInputs& inputs) {
  const Size size = inputs.filtered.size();
  RemodulateExact exact{ExactPlanes(size, 3), ExactPlanes(size, 3), ExactPlanes(size, 1),
                        BasicPlanes<char>(size, 1)};
  forEachPixel(size, [&](int x, int y) {
    const bool surface = isSurface(inputs.guides, x, y);
    Vector3d sum = Vector3d::Zero();
    for (int signal = 0; signal < inputs.material.signals(); ++signal) {
      const Material material = materialAt(inputs.material, x, y, signal);
      // What is there and has no weight is not to be filtered.
      const bool counts = inputs.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y) > 0.0f || !material.finite;
      const Remodulated result = remodulate(material, surface && counts, filteredAt(inputs, x, y, signal));
      sum += material.emission + result.light;
      double& magnitude = exact.magnitude.at(0, x, y);
      magnitude = std::max({magnitude, result.magnitude, material.emission.cwiseAbs().maxCoeff()});
      exact.undecided.at(0, x, y) |= char(material.undecided);
    }
    for (int c = 0; c < 3; ++c) {
      exact.linear.at(c, x, y) = std::clamp<double>(sum[c], 0.0, QUELL_MAX_RADIANCE);
      exact.encoded.at(c, x, y) = encodeDisplayExact(exact.linear.at(c, x, y));
    }
  });
  return exact;
}

}  // namespace quell::tests
