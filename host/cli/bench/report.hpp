// What the bench command says: as text, as JSON and as CSV.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/cli/bench/runner.hpp"

namespace quell::cli {

/// {copy_ms, copy_gbs, copy_gbs_measured: [...], build: {version, compiler, assertions}, fma_gflops, repeat, runs: [...], skipped: [...]}. A run is the object
/// that `quell denoise --json` writes, with these added: `input`, `run` (its name), `assignments`, `sweep`, `build_ms`
/// {cold, cached}, `round_medians_ms` and `frame_medians_ms` (of the frame times), and to each of its stages `gbs`,
/// `copies`, `copy_share`, `bound_ms` (roofline) and `operations` (floating-point, per frame). What was not asked for
/// is absent.
nlohmann::json toJson(const BenchResult& result);

/// One line for every stage of every run, for their sum, for the frame with the gaps between stages, and for
/// the errors against every reference frame; `kind` says which. Cells that do not apply are empty. Lines end
/// with a line feed; cells are quoted as in RFC 4180 where they need it.
std::string toCsv(const BenchResult& result);

/// The report of every run, then a table with one line per run.
void print(const BenchResult& result);

}  // namespace quell::cli
