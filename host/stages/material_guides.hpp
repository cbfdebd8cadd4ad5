// Host side of the stage material_guides.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/fit_features.hpp"

namespace quell {

/// See kernels/material_guides.cl for what it computes, from what and after which paper.
class MaterialGuides : public Stage {
 public:
  /// Only the images that these features need are read.
  explicit MaterialGuides(const FitFeatures& features) : m_features(features) {}
  std::string name() const override { return "material_guides"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  ImageView albedoOf(const Frame& frame) const;
  ImageView roughnessOf(const Frame& frame) const;

  FitFeatures m_features;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
