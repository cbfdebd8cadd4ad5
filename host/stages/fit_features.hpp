// The features of a fit: the language of the setting `features`, and what a list of them is compiled to.
//
// A list is separated by commas. The constant 1 is always a feature, always the first one, and may be left out.
//   nx ny nz        shading normal, world space                    group n
//   wx wy wz        position relative to the camera, world axes    group w
//   depth           along the view axis (perspective cameras)
//   gx gy           horizontal and vertical gradient, 0 to 1 over the block or window    group g
//   ar ag ab        albedo, red, green and blue                    group albedo
//   roughness       of the image Frame::roughness
//   v2 v3           square and cube of any of these, or v^2, v^3; w2 squares the group
//   sqrt(v)         square root of the absolute value; not of gx and gy
//   u*v             product; with groups, of every pair of components (w*w: of every two different ones)
//   u-v             difference of two components of n or of w; w-w: every two different ones
// That is the pool of the master's thesis of Flatval (2020), table 5.3, with the gradients and the roughness of
// Koskela et al. 2019. Departures: positions are relative to the camera instead of the world origin; powers and
// products are taken of variables that the block has scaled to [0, 1], which spans the same space as long as the
// lower powers are in the list; roots and differences of positions are taken first and then scaled.
#pragma once

#include <string>
#include <vector>

#include "kernels/gram_params.h"

namespace quell {

/// T of Koskela et al. 2019.
constexpr char kDefaultFeatures[] = "1,n,w,w2";

/// Where a quantity of a pixel comes from.
enum class FeatureSource { Position, Normal, Depth, Gradient, Albedo, Roughness };

/// A quantity of a pixel that features are products of.
struct FeatureVariable {
  std::string name;   ///< canonical, such as "wx", "sqrt(nx)" or "wy-wz"
  std::string value;  ///< in the terms of kernels/common/fit_features.h
  /// Unbounded variables are scaled to [0, 1] in every block; this is what rounding noise is measured by, an expression
  /// in `distance`. Empty: bounded, left as it is.
  std::string size;
  int order = 0;  ///< in products
  FeatureSource source = FeatureSource::Position;
};

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
  using Product = std::vector<FeatureVariable>;  // in canonical order; empty: the constant

  bool uses(FeatureSource source) const;
  void add(const Product& product);
  void collectScaled();
  std::vector<Product> closure() const;
  int scaledIndex(const FeatureVariable& variable) const;
  std::string productValue(const Product& product) const;
  std::string commonOptions(const std::vector<Product>& products) const;
  std::string rescaleList(const std::vector<Product>& products) const;
  std::string rescaleSteps(const std::vector<Product>& products, const std::string& variable) const;

  std::vector<Product> m_products;
  std::vector<FeatureVariable> m_scaled;
};

/// A list as its single features, groups taken apart; the constant is left out. Throws as FitFeatures().
std::vector<std::string> expandFeatures(const std::string& list);
/// The entries of a list as written, without blanks; "1" is left out.
std::vector<std::string> splitFeatures(const std::string& list);

}  // namespace quell
