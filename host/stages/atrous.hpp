// Host side of the stage atrous.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/edge_stops.hpp"
#include "kernels/atrous_params.h"

namespace quell {

/// One iteration; see kernels/atrous.cl for what it computes, from what and after which paper.
class Atrous : public Stage {
 public:
  struct Setup {
    EdgeStops stops;
    double luminanceSigma = 4.0;  ///< in standard deviations; in units of luminance without variance
    int step = 1;                 ///< pixels between taps
    std::string input;            ///< irradiance
    std::string output;
    std::string variance;     ///< empty: none
    std::string varianceOut;  ///< empty: not filtered along
    int radius = 2;           ///< 2: 5x5 taps, 1: 3x3
    bool corners = true;      ///< false: without the four corners of these
    /// Roughness below which the stop on luminance narrows, to half its width at 0; 0: nowhere.
    double sharpRoughness = 0.0;
    int iteration = 1;  ///< from 1 on
    bool skip = false;  ///< leaves out background; see kernels/common/surfaces.h
  };
  explicit Atrous(Setup setup) : m_setup(std::move(setup)) {}
  std::string name() const override { return "atrous"; }
  std::string label() const override { return "atrous (step " + std::to_string(m_setup.step) + ")"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration&) const override { return 0; }

 private:
  bool readsRoughness(const Frame& frame) const {
    return frame.roughness.present() && (m_setup.stops.roughnessSigma > 0.0 || m_setup.sharpRoughness > 0.0);
  }

  Setup m_setup;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
