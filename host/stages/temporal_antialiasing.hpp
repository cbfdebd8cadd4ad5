// Host side of the stage temporal_antialiasing.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/temporal_antialiasing_params.h"

namespace quell {

/// See kernels/temporal_antialiasing.cl for what it computes, from what and after which paper.
class TemporalAntialiasing : public Stage {
 public:
  /// `newestWeight`: weight of the newest frame, (0, 1].
  explicit TemporalAntialiasing(double newestWeight) : m_newestWeight(newestWeight) {}
  std::string name() const override { return "temporal_antialiasing"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  double m_newestWeight;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
