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

int guidedCellRadius(int subsampling) { return (kGuidedRadius + subsampling / 2) / subsampling; }

GuidedMomentsInputs guidedPixels(const CaseOptions& options, const GuidedVariant& variant) {
  const FilterGuides guides = randomGuides({variant.signals, false}, options);
  GuidedMomentsInputs pixels{{}, guides.guides, guides.viewDepth, variant.subsampling};
  pixels.irradiance = randomPlanes(options.size, 3 * variant.signals, options.seed + 10, 0.0, 4.0);
  forEachPixel(options.size, [&](int x, int y) {
    const float lit = std::abs(guides.guides.at(QUELL_GUIDE_NORMAL + 1, x, y));
    for (int plane = 0; plane < pixels.irradiance.count; ++plane)
      pixels.irradiance.at(plane, x, y) *= 1.0f + lit;
  });
  return pixels;
}

}  // namespace quell::tests
