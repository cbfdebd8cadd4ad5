// What GPUs that are not at hand would need at least, from bytes, operations and published rates.
#pragma once

#include <nlohmann/json.hpp>

#include "host/cli/bench/runner.hpp"

namespace quell::cli {

/// {note, gpus: [{name, gbs, gflops}], rows: [{run, ms: [one for each GPU], published: [text, may be empty]}]}: for the
/// runs of the first sequence, scaled to 1280x720. A stage takes as long as its bytes at the GPU's bandwidth or its
/// operations at its rate of multiply-adds, whichever is longer; a prediction, and a lower bound.
nlohmann::json predictGpus(const BenchResult& result);

}  // namespace quell::cli
