// Case of the stage guided_solve.
#pragma once

#include "tests/cases/guided_inputs.hpp"
#include "tests/oracle/guided_moments_oracle.hpp"
#include "tests/oracle/guided_solve_oracle.hpp"

namespace quell::tests {

/// Of predictions, relative to the brightness of the window: moments carry relative errors of 1e-6, which epsilon, a fiftieth
/// of the mean square, magnifies; and a guide that varies by no more than that counts as a constant.
constexpr double kGuidedSolveTolerance = 1e-4;

/// Windows over the scene of guided_moments_case.hpp.
class GuidedSolveCase : public StageCase {
 public:
  explicit GuidedSolveCase(const CaseOptions& options, const GuidedVariant& variant = {});

  /// The pixels of which windows are summed, in double precision, by upload().
  GuidedMomentsInputs pixels;

  void upload() override;
  /// Compares what fits say at the mean of their window and a deviation away from it along each guide.
  Comparison compare() override;
  double tolerance() const override { return kGuidedSolveTolerance; }
  /// Of cells.
  Planes coefficients() const;

 protected:
  std::vector<LightInput> light() override { return {lightOf(pixels.irradiance)}; }

 private:
  void compareWindow(Comparison& comparison, const Planes& device, const GuidedFit& fit, int signal, int x,
                     int y) const;

  GuidedSolveInputs m_inputs;
};

}  // namespace quell::tests
