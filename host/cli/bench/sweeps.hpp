// Series of runs over one setting, or over sizes, that have a name.
#pragma once

#include <string>
#include <vector>

#include "host/cli/common/run_plan.hpp"

namespace quell::cli {

/// sizes, background, features, windows, iterations, weight, storage, taa, fbeta.
std::vector<std::string> sweepNames();

/// The runs of a sweep: of `methods`, those that have its settings. Throws Error(InvalidArgument) for an unknown name
/// or if none of the methods has them.
std::vector<PlannedRun> planSweep(const std::string& name, const std::vector<std::string>& methods);

/// Sizes of the built-in sequence that a sweep runs on; empty: it runs on what the command line names.
std::vector<std::string> sweepSizes(const std::string& name);

/// Shares of sky, in [0, 1], of the built-in sequence that a sweep runs on; empty: as the sequence is.
std::vector<double> sweepSkyShares(const std::string& name);

/// Whether some of its runs need a roughness image.
bool sweepNeedsRoughness(const std::string& name);

}  // namespace quell::cli
