// Host side of the stage temporal_antialiasing.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/temporal_antialiasing_params.h"

namespace quell {

/// See kernels/temporal_antialiasing.cl for what it computes, from what and after which paper.
class TemporalAntialiasing : public Stage {
 public:
  /// `newestWeight`: weight of the newest frame, (0, 1]; `skip`: leaves background to the stage background, unless rays
  /// are jittered.
  TemporalAntialiasing(double newestWeight, bool skip) : m_newestWeight(newestWeight), m_skip(skip) {}
  std::string name() const override { return "temporal_antialiasing"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  double m_newestWeight;
  bool m_skip;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
