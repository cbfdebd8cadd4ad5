// Case of the stage light_gain.
#pragma once

#include "tests/cases/stage_case.hpp"
#include "tests/oracle/light_gain_oracle.hpp"

namespace quell::tests {

/// Relative to the gain as if no tile's loss made up for another's: sums of 121 products.
constexpr double kLightGainTolerance = 1e-5;

/// Tiles that lost light and some that won, of different brightness; some without any light.
class LightGainCase : public StageCase {
 public:
  explicit LightGainCase(const CaseOptions& options, int signals = 1);

  LightGainInputs inputs;

  int tileCount() const { return TileGrid(size()).count() * inputs.signals; }
  /// The record of a tile.
  void setTile(int tile, double lost, double squares);

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kLightGainTolerance; }
  Planes gains() const { return m_harness.download("lightGain"); }

 protected:
  std::vector<LightInput> light() override;
};

}  // namespace quell::tests
