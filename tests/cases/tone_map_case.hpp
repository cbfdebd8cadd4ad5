// Case of the stage tone_map.
#pragma once

#include "tests/cases/stage_case.hpp"

namespace quell::tests {

/// /// Largest absolute error of the encoding over [0, 1]. Results near 1 have the largest: rounding of a
/// result below 1 (6e-8) and of an exponent below 1/2 in magnitude (2e-8), with room for compilers that
/// divide less exactly.
constexpr double kToneMapTolerance = 3e-7;

class ToneMapCase : public StageCase {
 public:
  /// `isLast`: into the caller's display image in options.layout instead of planes.
  explicit ToneMapCase(const CaseOptions& options, bool isLast = false);

  Planes linear;  ///< input, 3 planes

  void upload() override;
  Comparison compare() override;
  double tolerance() const override;
  Planes encoded() const { return m_harness.download("encoded"); }

 private:
  bool m_isLast;
  ImageLayout m_layout;
};

}  // namespace quell::tests
