// Host side of the stage accumulate_noisy.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/accumulate_noisy_params.h"

namespace quell {

/// See kernels/accumulate_noisy.cl for what it computes, from what and after which paper.
class AccumulateNoisy : public Stage {
 public:
  struct Setup {
    double leastWeight = 0.2;                        ///< least weight of the newest sample, (0, 1]
    double momentsLeastWeight = 0.0;                 ///< the same for the moments; 0: no moments
    std::string irradiancePrev = "irradiance.prev";  ///< the buffer that the history comes from
    bool filterGuides = false;                       ///< view depth and roughness for edge stops
    int mostFrames = QUELL_MAX_HISTORY_LENGTH;       ///< longest history, frames, 1 to 255
    int mostFramesStill = QUELL_MAX_HISTORY_LENGTH;  ///< the same of pixels that do not move on the screen
    bool skip = false;                               ///< leaves out background; see kernels/common/surfaces.h
    bool innovation = false;                         ///< newest sample and its difference to the history
  };
  explicit AccumulateNoisy(Setup setup) : m_setup(std::move(setup)) {}
  std::string name() const override { return "accumulate_noisy"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  bool hasMoments() const { return m_setup.momentsLeastWeight > 0.0; }

  Setup m_setup;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
