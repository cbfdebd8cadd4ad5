// Case of the stage virtual_motion.
#pragma once

#include "tests/cases/edagi_inputs.hpp"
#include "tests/oracle/virtual_motion_oracle.hpp"

namespace quell::tests {

/// Relative to the distance of a point; indices of pixels are given half a step of rounding on top.
constexpr double kVirtualMotionTolerance = 2e-6;

/// With `parallel` rays go along the view axis. The test scene as mirrors of all kinds: hit distances near and far, none, and broken ones.
class VirtualMotionCase : public StageCase {
 public:
  explicit VirtualMotionCase(const CaseOptions& options, bool parallel = false);

  VirtualMotionInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kVirtualMotionTolerance; }
  Planes positions() const { return m_harness.download("virtualPositions"); }
  Planes pixelPrev() const { return m_harness.download("virtualPixelPrev"); }
  Planes mask() const { return m_harness.download("virtualMask"); }
};

}  // namespace quell::tests
