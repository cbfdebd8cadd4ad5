// Double-precision oracle of the features of a fit: evaluates them by their canonical names, see
// host/stages/feature_list.hpp. Nothing here comes from what the kernels are compiled with.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "host/stages/fit_features.hpp"
#include "kernels/accumulate_noisy_params.h"
#include "tests/support/planes.hpp"

namespace quell::tests {

/// Planes that the inputs of a case hold: guides, then materials.
constexpr int kGuideAndMaterialPlanes = QUELL_GUIDE_PLANES_OF(1) + QUELL_MATERIAL_PLANES;

/// The materials among such planes, as the stages get them.
Planes materialsOf(const Planes& guides);

/// True where the normal is zero.
bool isBackground(const Planes& guides, int x, int y);

/// A list of features.
struct FeatureNames {
  std::vector<std::string> features;              ///< "1" first
  std::vector<std::vector<std::string>> factors;  ///< of each feature
  std::vector<std::string> scaled;                ///< unbounded variables, in the order of a record
  std::array<double, 3> viewAxis{0, 0, -1};       ///< of the feature depth

  int count() const { return int(features.size()); }
};
FeatureNames namesOf(const FitFeatures& features);
/// Those of the method's default.
const FeatureNames& defaultNames();
/// The features whose sums gram_sums collects.
FeatureNames gramNamesOf(const FitFeatures& features, bool overlap);

/// The factors of a feature, sorted: "wx2*ny" is ny, wx, wx; none for "1".
std::vector<std::string> factorsOf(const std::string& feature);
bool isScaled(const FeatureNames& list, const std::string& variable);

using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, QUELL_FIT_CHANNELS>;

/// The record of one block.
struct FitRecord {
  explicit FitRecord(const FeatureNames& names = defaultNames());

  FeatureNames list;
  Coefficients coefficients;          ///< 0 to start with
  std::vector<double> anchor, scale;  ///< of the unbounded variables; 0 and 1 to start with
  bool usable = true;
};

/// A record as the device stores it.
FitRecord unpackRecord(const Planes& records, int block, const FeatureNames& list = defaultNames());
Planes packRecords(const std::vector<FitRecord>& records);

/// T for one pixel in the scaling of a record: features without noise.
Eigen::RowVectorXd features(const Planes& guides, const FitRecord& record, int x, int y);

/// Range of the unbounded variables; low > high where there is none.
struct VariableRange {
  explicit VariableRange(const FeatureNames& names);

  FeatureNames list;
  std::vector<double> low, high;

  bool empty() const { return !low.empty() && low[0] > high[0]; }
  void include(const VariableRange& other);
  /// Adds a pixel.
  void include(const Planes& guides, int x, int y);
};

/// A record without coefficients that maps the range to [0, 1].
FitRecord scalingOf(const VariableRange& range);

}  // namespace quell::tests
