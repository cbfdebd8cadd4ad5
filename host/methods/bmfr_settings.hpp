// Settings of the method bmfr.
#pragma once

#include "host/methods/common_settings.hpp"
#include "host/stages/fit.hpp"

namespace quell {

/// How the least-squares problem is solved.
enum class Solver { Householder, Gram };
constexpr std::array<const char*, 2> choiceNames(Solver) { return {"householder", "gram"}; }

/// What is fitted.
enum class Windows { Blocks, Overlap };
constexpr std::array<const char*, 2> choiceNames(Windows) { return {"blocks", "overlap"}; }

struct BmfrSettings {
  double noisyLeastWeight;
  double filteredLeastWeight;
  double fireflyRatio;
  FitFeatures features = FitFeatures();
  double noiseAmplitude;
  Solver solver;
  Windows windows;
  int tileSize;  ///< pixels
  FeatureStorage featureStorage;
  CommonSettings common;
};

inline SettingTable<BmfrSettings> bmfrSettings() {
  using S = BmfrSettings;
  SettingTable<S> table;
  table.add("noisyLeastWeight", &S::noisyLeastWeight, 0.2, {0.001, 1.0},
            "least weight of the newest noisy sample", "Koskela et al. 2019, phase I");
  table.add("filteredLeastWeight", &S::filteredLeastWeight, 0.1, {0.001, 1.0},
            "least weight of the newest filtered frame", "Koskela et al. 2019, phase III");
  addFireflyRatio(table, &S::fireflyRatio).paper(0.0);
  table.add(
      "features", &S::features, kDefaultFeatures,
      "features of the fit, separated by commas: the constant 1 (implied), normal n (or nx, ny, nz), "
      "position w, depth, gradients g, albedo, roughness; squares w2, cubes w3, sqrt(w), products wx*ny, "
      "differences wx-wy; at most 16 scalars",
      "Koskela et al. 2019, section on feature buffers; Flatval 2020, table 5.3");
  table.add("noiseAmplitude", &S::noiseAmplitude, 0.01, {0.0, 1.0, "scaled feature units"},
            "amplitude of the stochastic regularisation", "Koskela et al. 2019, phase II");
  table.add(
      "solver", &S::solver, Solver::Householder,
      "how the least-squares problem is solved: QR of the pixels, or normal equations from sums over tiles",
      "Koskela et al. 2019, phase II (householder)");
  table.add(
      "windows", &S::windows, Windows::Blocks,
      "what is fitted: displaced 32x32 blocks, or overlapping windows of 3x3 tiles, blended (gram only)",
      "Koskela et al. 2019, phase II (blocks)");
  table.addOneOf("tileSize", &S::tileSize, {8, 16}, "pixels", "edge of a tile (overlapping windows only)",
                 "16 has a higher error at 480x270");
  table.add("featureStorage", &S::featureStorage, FeatureStorage::Float,
            "format of the matrix while a block is factorised (householder only)",
            "Koskela et al. 2019, reference implementation (half)");
  table.include(&S::common, commonSettings());
  return table;
}

}  // namespace quell
