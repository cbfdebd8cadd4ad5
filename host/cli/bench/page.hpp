// The results of quell bench as one self-contained page.
#pragma once

#include <string>

#include "host/cli/bench/runner.hpp"

namespace quell::cli {

/// HTML with style, script, results and pictures in it: it opens from disk and loads nothing.
std::string toHtml(const BenchResult& result);

}  // namespace quell::cli
