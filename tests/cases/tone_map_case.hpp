// Case of the stage tone_map.
#pragma once

#include "tests/cases/stage_case.hpp"

namespace quell::tests {

/// Largest absolute error of the encoding over [0, 1]. Rounding of the exponent's argument dominates: log2 of
/// the smallest values has a rounding error near 2^-19, which 2^(log2(x) / 2.2) hands on in proportion to its
/// own size.
constexpr double kToneMapTolerance = 1e-6;

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
