// Which settings are worth choosing from: those that no other beats in everything at once.
#pragma once

#include <vector>

namespace quell::cli {

/// What a setting costs, in units of any kind; less is better in all. Not NaN.
struct Costs {
  double time = 0.0;           ///< >= 0
  std::vector<double> errors;  ///< as many for every setting
};

/// True if `a` is as good as `b` in everything and better in something. Times that differ by a share of up to
/// `timeTolerance` (>= 0) count as equal: measured times never are. No cycles: of some settings there is always one
/// that none of the others dominates.
bool dominates(const Costs& a, const Costs& b, double timeTolerance);

/// For every setting, whether it is in the Pareto set: no other dominates it. Equals stay in it together.
std::vector<bool> paretoSet(const std::vector<Costs>& settings, double timeTolerance);

}  // namespace quell::cli
