#include "host/stages/material_guides.hpp"

#include "kernels/material_guides_params.h"

namespace quell {

ImageView MaterialGuides::albedoOf(const Frame& frame) const {
  return m_features.needAlbedo() ? frame.albedo : ImageView{};
}

ImageView MaterialGuides::roughnessOf(const Frame& frame) const {
  return m_features.needRoughness() ? frame.roughness : ImageView{};
}

void MaterialGuides::build(const KernelBuilder& builder) {
  const Frame& frame = builder.configuration().frame;
  m_kernel = builder.build("material_guides", layoutOptions("ALBEDO", albedoOf(frame)) +
                                                  layoutOptions("ROUGHNESS", roughnessOf(frame)));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void MaterialGuides::enqueue(FrameRun& run) {
  const Size size = run.configuration.size();
  const ImageView albedo = albedoOf(run.frame), roughness = roughnessOf(run.frame);
  MaterialGuidesParams params{};
  params.planes = makePlanes(size);
  params.albedo = makeViewParams(albedo, size);
  params.roughness = makeViewParams(roughness, size);
  run.launch(m_kernel, run.pixelRange(), m_workGroup, albedo, roughness, run.buffer("materials"), params);
}

std::uint64_t MaterialGuides::callerBytes(const Configuration& configuration) const {
  const Frame& frame = configuration.frame;
  return imageBytes(albedoOf(frame), frame.size) + imageBytes(roughnessOf(frame), frame.size);
}

}  // namespace quell
