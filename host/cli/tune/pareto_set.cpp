#include "host/cli/tune/pareto_set.hpp"

#include <algorithm>

namespace quell::cli {

bool dominates(const Costs& a, const Costs& b, double timeTolerance) {
  const double tolerated = 1.0 + timeTolerance;
  bool better = a.time * tolerated < b.time;
  for (std::size_t i = 0; i < a.errors.size(); ++i) {
    if (a.errors[i] > b.errors[i]) return false;
    better = better || a.errors[i] < b.errors[i];
  }
  return better && a.time <= b.time * tolerated;
}

std::vector<bool> paretoSet(const std::vector<Costs>& settings, double timeTolerance) {
  std::vector<bool> inSet;
  for (const Costs& one : settings)
    inSet.push_back(std::none_of(settings.begin(), settings.end(),
                                 [&](const Costs& other) { return dominates(other, one, timeTolerance); }));
  return inSet;
}

}  // namespace quell::cli
