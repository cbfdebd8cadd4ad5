// Host side of the stage material_guides.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/fit_features.hpp"
#include "kernels/material_guides_ports.h"

namespace quell {

QUELL_OPTIONS(MaterialGuidesOptions, MATERIAL_GUIDES, "material_guides")

/// See kernels/material_guides.cl for what it computes, from what and after which paper.
class MaterialGuides : public KernelStage<MaterialGuidesOptions, MaterialGuidesParams> {
 public:
  /// Only the images that these features need are read.
  explicit MaterialGuides(const FitFeatures& features);

 protected:
  MaterialGuidesParams params(const FrameRun& run) const override;
};

}  // namespace quell
