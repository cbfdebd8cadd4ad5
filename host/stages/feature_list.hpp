// The language of the setting `features`.
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

#include <cstddef>
#include <string>
#include <vector>

namespace quell {

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

/// In canonical order of its factors; empty: the constant.
using FeatureProduct = std::vector<FeatureVariable>;

/// Factors of a product at most.
constexpr std::size_t kMostFactors = 3;

/// Throws Error(OutOfRange) that names the setting.
[[noreturn]] void refuseFeatures(const std::string& expected, const std::string& got);

/// The entries of a list as written, without blanks.
std::vector<std::string> splitEntries(const std::string& list);
/// The same without the constant.
std::vector<std::string> splitFeatures(const std::string& list);
bool isConstant(const std::string& entry);

/// The products that an entry stands for; none for the constant. Throws Error(OutOfRange) naming what is unknown.
std::vector<FeatureProduct> parseEntry(const std::string& entry);

/// wx, wy, wz.
std::vector<FeatureVariable> positionVariables();

/// Canonical name, itself an entry of a list.
std::string nameOf(const FeatureProduct& product);
/// How often the variable of this name is a factor.
std::size_t powerIn(const FeatureProduct& product, const std::string& variable);

}  // namespace quell
