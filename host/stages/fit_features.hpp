// The features of a fit: what a list of them (feature_list.hpp) is compiled to.
#pragma once

#include <string>
#include <vector>

#include "host/stages/feature_list.hpp"
#include "kernels/gram_params.h"

namespace quell {

/// T of Koskela et al. 2019.
constexpr char kDefaultFeatures[] = "1,n,w,w2";

class FitFeatures {
 public:
  /// Reads a list. Throws Error(OutOfRange) naming what is unknown, given twice or too much.
  explicit FitFeatures(const std::string& list = kDefaultFeatures);

  /// Scalar features, the constant one included: 1 to QUELL_MOST_FEATURES.
  int count() const { return static_cast<int>(m_products.size()); }
  /// Their canonical names, "1" first. Canonical names are themselves a list.
  std::vector<std::string> names() const;
  /// Unbounded variables, each with an anchor and a scale in every record.
  int scaledCount() const { return static_cast<int>(m_scaled.size()); }
  std::vector<std::string> scaledNames() const;

  /// Whether they are made of the caller's images of that name.
  bool needAlbedo() const { return uses(FeatureSource::Albedo); }
  bool needRoughness() const { return uses(FeatureSource::Roughness); }
  bool needMaterial() const { return needAlbedo() || needRoughness(); }
  bool needNormal() const { return uses(FeatureSource::Normal); }
  bool needPosition() const { return uses(FeatureSource::Position) || uses(FeatureSource::Depth); }

  /// Features whose sums gram_sums collects. For overlapping windows these are all features of the list and what a
  /// change of scaling brings in: every product with some of its unbounded factors left out. Throws Error(OutOfRange) if
  /// those are more than QUELL_MOST_GRAM_FEATURES.
  std::vector<std::string> gramNames(bool overlap) const;
  int gramCount(bool overlap) const { return static_cast<int>(gramNames(overlap).size()); }

  /// Compile options of the stages fit, weighted_sum and blended_sum.
  std::string options() const;
  /// Compile options of gram_sums and gram_solve.
  std::string gramOptions(bool overlap) const;

  /// Sizes of a record and of a tile's sums, in floats.
  int recordSize() const { return QUELL_FIT_RECORD_OF(count(), scaledCount()); }
  int gramPlanes(bool overlap) const { return QUELL_GRAM_PLANES_OF(gramCount(overlap), scaledCount()); }

 private:
  bool uses(FeatureSource source) const;
  void add(const FeatureProduct& product);
  void collectScaled();
  std::vector<FeatureProduct> closure() const;
  int scaledIndex(const FeatureVariable& variable) const;
  std::string productValue(const FeatureProduct& product) const;
  std::string commonOptions(const std::vector<FeatureProduct>& products) const;
  std::string rescaleList(const std::vector<FeatureProduct>& products) const;
  std::string rescaleSteps(const std::vector<FeatureProduct>& products, const std::string& variable) const;

  std::vector<FeatureProduct> m_products;
  std::vector<FeatureVariable> m_scaled;
};

/// A list as its single features, groups taken apart; the constant is left out. Throws as FitFeatures().
std::vector<std::string> expandFeatures(const std::string& list);

}  // namespace quell
