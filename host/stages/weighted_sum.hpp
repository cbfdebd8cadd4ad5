// Host side of the stage weighted_sum.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/fit_features.hpp"

namespace quell {

/// See kernels/weighted_sum.cl for what it computes, from what and after which paper.
class WeightedSum : public Stage {
 public:
  /// `signal`: the one that is fitted, 0 or 1.
  WeightedSum(const FitFeatures& features, int signal) : m_features(features), m_signal(signal) {}
  std::string name() const override { return "weighted_sum"; }
  std::string label() const override;
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  FitFeatures m_features;
  int m_signal;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
