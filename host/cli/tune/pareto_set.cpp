#include "host/cli/tune/pareto_set.hpp"

#include <algorithm>

namespace quell::cli {

bool dominates(const Costs& a, const Costs& b, double timeTolerance) {
  const double tolerated = 1.0 + timeTolerance;
  if (a.time > b.time * tolerated || a.rmse > b.rmse || a.flip > b.flip) return false;
  return a.time * tolerated < b.time || a.rmse < b.rmse || a.flip < b.flip;
}

std::vector<bool> paretoSet(const std::vector<Costs>& settings, double timeTolerance) {
  std::vector<bool> inSet;
  for (const Costs& one : settings)
    inSet.push_back(std::none_of(settings.begin(), settings.end(),
                                 [&](const Costs& other) { return dominates(other, one, timeTolerance); }));
  return inSet;
}

}  // namespace quell::cli
