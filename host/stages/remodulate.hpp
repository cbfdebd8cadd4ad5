// Host side of the stage remodulate.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/remodulate_params.h"

namespace quell {

/// See kernels/remodulate.cl for what it computes, from what and after which paper.
class Remodulate : public Stage {
 public:
  /// `filtered`: the buffer with the filtered irradiance; `writePlanes`: whether a later stage reads the display-encoded
  /// radiance, else it is the caller's if he wants it; `skip`: leaves background to the stage background.
  Remodulate(std::string filtered, bool writePlanes, bool skip)
      : m_filtered(std::move(filtered)), m_writePlanes(writePlanes), m_skip(skip) {}
  std::string name() const override { return "remodulate"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  ImageView displayOutput(const Output& output) const { return m_writePlanes ? ImageView() : output.display; }

  std::string m_filtered;
  bool m_writePlanes;
  bool m_skip;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
