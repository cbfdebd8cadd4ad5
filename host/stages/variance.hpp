// Host side of the stage variance.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/edge_stops.hpp"
#include "kernels/variance_params.h"

namespace quell {

/// See kernels/variance.cl for what it computes, from what and after which paper.
class Variance : public Stage {
 public:
  /// `temporalFrames`: history length from which on the variance over time is trusted, 1 to 255.
  Variance(const EdgeStops& stops, int temporalFrames) : m_stops(stops), m_temporalFrames(temporalFrames) {}
  std::string name() const override { return "variance"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration&) const override { return 0; }

 private:
  EdgeStops m_stops;
  int m_temporalFrames;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
