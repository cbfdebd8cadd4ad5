// Case of the stage box_filter.
#pragma once

#include "tests/cases/guided_inputs.hpp"
#include "tests/oracle/box_filter_oracle.hpp"

namespace quell::tests {

/// Relative to the sum of the magnitudes: up to 19 terms in one chain.
constexpr double kBoxFilterTolerance = 2e-6;

/// Which of a guided filter's passes, in the order of its table.
enum class BoxPass { MomentColumns, MomentRows, CoefficientColumns, CoefficientRows };

/// Random numbers of either sign in the cells of a guided filter.
class BoxFilterCase : public StageCase {
 public:
  explicit BoxFilterCase(const CaseOptions& options, BoxPass pass = BoxPass::MomentRows,
                         const GuidedVariant& variant = {});

  Planes input;  ///< of cells

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kBoxFilterTolerance; }
  Planes sums() const;

 protected:
  std::vector<LightInput> light() override { return {lightOf(input)}; }

 private:
  BoxPass m_pass;
  int m_radius;  // cells
};

}  // namespace quell::tests
