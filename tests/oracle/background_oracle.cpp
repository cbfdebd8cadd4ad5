#include "tests/oracle/background_oracle.hpp"

#include <algorithm>
#include <cmath>

#include "tests/oracle/display_encoding_oracle.hpp"

namespace quell::tests {
namespace {

constexpr double kMostRadiance = 65504.0;  // the largest finite half

bool isWhole(const io::Image& image, int x, int y) {
  for (int c = 0; c < 3; ++c)
    if (!std::isfinite(image.at(x, y, c))) return false;
  return true;
}

}  // namespace

BackgroundExact backgroundOracle(const BackgroundInputs& inputs) {
  const Size size{inputs.radiance.width, inputs.radiance.height};
  BackgroundExact exact{ExactPlanes(size, 3), ExactPlanes(size, 3)};
  forEachPixel(size, [&](int x, int y) {
    const bool emissionWhole = isWhole(inputs.emission, x, y);
    const bool whole = isWhole(inputs.radiance, x, y) && emissionWhole;
    for (int c = 0; c < 3; ++c) {
      const double emission =
          emissionWhole ? std::clamp<double>(inputs.emission.at(x, y, c), 0.0, kMostRadiance) : 0.0;
      const double signal =
          whole ? std::clamp(inputs.radiance.at(x, y, c) - emission, 0.0, kMostRadiance) : 0.0;
      // Emission is added back as far as radiance has it.
      const double included =
          whole ? std::min<double>(emission, std::max(inputs.radiance.at(x, y, c), 0.0f)) : emission;
      const double radiance = std::min(signal + included, kMostRadiance);
      exact.linear.at(c, x, y) = radiance;
      exact.encoded.at(c, x, y) = encodeDisplayExact(radiance);
    }
  });
  return exact;
}

}  // namespace quell::tests
