#include "tests/oracle/tone_map_oracle.hpp"

#include <algorithm>
#include <cmath>

namespace quell::tests {
namespace {

constexpr double kDisplayGamma = 2.2;  // Koskela et al. 2019, reference implementation

}  // namespace

double encodeDisplayExact(double linear) {
  if (std::isnan(linear)) return 0.0;
  return std::pow(std::clamp(linear, 0.0, 1.0), 1.0 / kDisplayGamma);
}

ExactPlanes toneMapOracle(const Planes& linear) {
  ExactPlanes encoded(linear.size(), linear.count);
  std::transform(linear.values.begin(), linear.values.end(), encoded.values.begin(),
                 [](float v) { return encodeDisplayExact(v); });
  return encoded;
}

}  // namespace quell::tests
