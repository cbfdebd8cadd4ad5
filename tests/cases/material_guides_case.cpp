#include "tests/cases/material_guides_case.hpp"

#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

ImageLayout roughnessLayout(ImageLayout layout) {
  layout.channels = 1;
  return layout;
}

StageSetup makeMaterialGuidesSetup(const CaseOptions& options) {
  CaseOptions withMaterials = options;
  withMaterials.features = "albedo,roughness";
  StageSetup setup = makeSetup(withMaterials);
  setup.frame.albedo = makeView(options.layout, options.size);
  setup.frame.roughness = makeView(roughnessLayout(options.layout), options.size);
  return setup;
}

}  // namespace

MaterialGuidesCase::MaterialGuidesCase(const CaseOptions& options)
    : StageCase("material_guides", makeMaterialGuidesSetup(options)), m_layout(options.layout) {
  inputs.albedo = randomImage(options.size, options.layout.channels, options.seed, -0.1, 1.1);
  inputs.roughness = randomImage(options.size, 1, options.seed + 1, -0.1, 1.1);
}

void MaterialGuidesCase::upload() {
  m_harness.setInput(&Frame::albedo, inputs.albedo);
  m_harness.setInput(&Frame::roughness, inputs.roughness);
}

Comparison MaterialGuidesCase::compare() {
  Comparison comparison;
  comparePixels(comparison, "materials", materials(), materialGuidesOracle(inputs));
  return comparison;
}

}  // namespace quell::tests
