// Host side of the stage tone_map.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/tone_map_params.h"

namespace quell {

/// See kernels/tone_map.cl for what it computes, from what and after which paper.
class ToneMap : public Stage {
 public:
  /// `isLast`: writes the caller's display image instead of planes for a later stage; `skip`: leaves background
  /// to the stage background.
  ToneMap(bool isLast, bool skip) : m_isLast(isLast), m_skip(skip) {}
  std::string name() const override { return "tone_map"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  bool m_isLast;
  bool m_skip;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
