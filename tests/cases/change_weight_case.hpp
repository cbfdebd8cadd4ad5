// Case of the stage change_weight.
#pragma once

#include "tests/cases/change_inputs.hpp"
#include "tests/oracle/change_weight_oracle.hpp"

namespace quell::tests {

/// Of weights up to 1: the spread is a difference of terms at most ten times as large (1e-6 measured).
constexpr double kChangeWeightTolerance = 1e-5;

/// Tiles without and with few comparable pixels among full ones; differences from within the noise to far beyond.
class ChangeWeightCase : public StageCase {
 public:
  explicit ChangeWeightCase(const CaseOptions& options, int signals = 1,
                            ChangeSettings settings = ChangeSettings::Unusual);

  ChangeWeightInputs inputs;

  /// The record of a tile: `count` differences with this mean and this spread (a variance).
  void setTile(int tile, double count, double mean, double spread);
  int tileCount() const { return TileGrid(size()).count() * inputs.signals; }

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kChangeWeightTolerance; }
  Planes weights() const { return m_harness.download("changeWeights"); }
};

}  // namespace quell::tests
