// Host side of the stage variance.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/edge_stops.hpp"
#include "kernels/variance_params.h"

namespace quell {

/// See kernels/variance.cl for what it computes, from what and after which paper.
class Variance : public Stage {
 public:
  struct Setup {
    EdgeStops stops;
    int temporalFrames = 4;  ///< history length from which on the variance over time is trusted, 1 to 255
    bool skip = false;       ///< leaves out background; see kernels/common/surfaces.h
    bool ofMean = false;     ///< variance of the mean over the history, else of its samples
  };
  explicit Variance(const Setup& setup) : m_setup(setup) {}
  std::string name() const override { return "variance"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration&) const override { return 0; }

 private:
  Setup m_setup;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
