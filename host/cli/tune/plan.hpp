// What the tune command shall compare, and on which sequences.
#pragma once

#include <string>
#include <vector>

#include "host/cli/common/run_plan.hpp"

namespace quell::cli {

/// The method's defaults first, then all combinations of the values; those that come to the same settings as an
/// earlier one on every sequence are left out. Throws as planRuns().
std::vector<PlannedRun> planTuning(const std::string& method, const std::vector<Variation>& variations,
                                   const std::vector<BenchInput>& inputs);

/// The default values of what is varied: "iterations=5 normalPower=16".
std::string defaultsText(const std::string& method, const std::vector<Variation>& variations);

/// Throws Error(InvalidArgument) if a directory is in both lists, however it is spelled: settings cannot be confirmed
/// where they were tuned.
void checkApart(const std::vector<std::string>& tuned, const std::vector<std::string>& confirmed);

/// Throws Error(InvalidArgument) naming the first sequence none of whose frames can be compared with a reference.
void checkReferences(const std::vector<BenchInput>& inputs);

}  // namespace quell::cli
