#include "host/stages/material_guides.hpp"

// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(MaterialGuidesOptions, MATERIAL_GUIDES)

MaterialGuides::MaterialGuides(const FitFeatures& features) {
  USES_ALBEDO = features.needAlbedo() ? 1 : 0;
  USES_ROUGHNESS = features.needRoughness() ? 1 : 0;
}

MaterialGuidesParams MaterialGuides::params(const FrameRun& run) const {
  MaterialGuidesParams params{};
  params.planes = makePlanes(run.frame.size);
  params.images = makeImageParams(run.frame);
  return params;
}

}  // namespace quell
