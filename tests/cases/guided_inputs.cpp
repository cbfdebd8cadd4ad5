#include "tests/cases/guided_inputs.hpp"

#include <cmath>

#include "kernels/common/guides.h"
#include "tests/support/random_images.hpp"

namespace quell::tests {

StageSetup makeGuidedSetup(const CaseOptions& options, const GuidedVariant& variant) {
  StageSetup setup = makeSetup(options);
  setup.frame.radiance = makeView(packed(3), setup.size);
  if (variant.signals == 2) setup.frame.glossyRadiance = makeView(packed(3), setup.size);
  setup.settings = Settings("guided");
  setup.settings.set("subsampling", std::to_string(variant.subsampling));
  setup.settings.set("epsilon", kGuidedEpsilon);
  setup.settings.set("radius", double(kGuidedRadius));
  return setup;
}

Planes guidedIrradiance(const FilterGuides& guides, const CaseOptions& options, int signals) {
  Planes irradiance = randomPlanes(options.size, 3 * signals, options.seed + 10, 0.0, 4.0);
  forEachPixel(options.size, [&](int x, int y) {
    const float lit = std::abs(guides.guides.at(QUELL_GUIDE_NORMAL + 1, x, y));
    for (int plane = 0; plane < irradiance.count; ++plane) irradiance.at(plane, x, y) *= 1.0f + lit;
  });
  return irradiance;
}

}  // namespace quell::tests
