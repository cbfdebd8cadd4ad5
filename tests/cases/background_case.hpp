// Case of the stage background.
#pragma once

#include "tests/cases/stage_case.hpp"
#include "tests/oracle/background_oracle.hpp"

namespace quell::tests {

/// Of linear radiance, relative; of encoded radiance kEncodingTolerance.
constexpr double kBackgroundTolerance = 3e-7;

class BackgroundCase : public StageCase {
 public:
  /// The caller's images are in options.layout, the method is quell with temporal antialiasing.
  explicit BackgroundCase(const CaseOptions& options);

  BackgroundInputs inputs;
  Planes surfaces;  ///< one value a work-item, not 0 where it has a surface

  bool isBackground(int x, int y) const;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kBackgroundTolerance + storageError(m_layout); }
  Planes denoised() const { return m_harness.download("beforeAntialiasing"); }
  Planes antialiased() const { return m_harness.download("antialiased"); }

 protected:
  std::vector<LightInput> light() override { return {lightOf(inputs.radiance), lightOf(inputs.emission)}; }

 private:
  ImageLayout m_layout;
  int m_lanes = 1;
};

}  // namespace quell::tests
