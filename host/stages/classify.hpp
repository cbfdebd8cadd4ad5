// Host side of the stage classify.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/classify_params.h"
#include "kernels/common/tiles.h"

namespace quell {

/// Tiles of an image along x and y.
std::array<int, 2> tileGrid(Size size);

/// See kernels/classify.cl for what it computes, from what and after which paper.
class Classify : public Stage {
 public:
  /// `iterations` of the filter, 1 to 7; `tolerance`: noise that may stay, standard deviations of display-encoded
  /// values; 0: none.
  Classify(int iterations, double tolerance) : m_iterations(iterations), m_tolerance(tolerance) {}
  std::string name() const override { return "classify"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration&) const override { return 0; }

 private:
  int m_iterations;
  double m_tolerance;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
