// Case of the stage change_weight.
#pragma once

#include "tests/cases/change_inputs.hpp"
#include "tests/oracle/change_weight_oracle.hpp"

namespace quell::tests {

/// Of weights up to 1: the spread is a difference of terms at most ten times as large (1e-6 measured).
constexpr double kChangeWeightTolerance = 1e-5;

/// Tiles without and with few comparable pixels among full ones; differences from within the noise to far beyond;
/// recent change from none to sure.
class ChangeWeightCase : public StageCase {
 public:
  explicit ChangeWeightCase(const CaseOptions& options, int signals = 1,
                            ChangeSettings settings = ChangeSettings::Unusual);

  ChangeWeightInputs inputs;

  /// Mean and spread (a variance) of differences.
  struct Differences {
    double mean, spread;
  };

  /// The record of a tile: `count` differences.
  void setTile(int tile, double count, Differences luminance, Differences chrominance);
  int tileCount() const { return TileGrid(size()).count() * inputs.signals; }

  /// Frame 0 has no frame before.
  void useFrame(std::uint32_t frameIndex);
  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kChangeWeightTolerance; }
  Planes weights() const { return m_harness.download("changeWeights"); }
  Planes recentChange() const { return m_harness.download("recentChange"); }

 protected:
  std::vector<LightInput> light() override { return lightOfRecords(inputs.sums); }
};

}  // namespace quell::tests
