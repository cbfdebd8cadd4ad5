// The page of host/cli/bench/page, embedded with its style and scripts.
#pragma once

namespace quell::cli {

/// HTML; "@RESULTS@" stands where the results belong.
extern const char* const kReportPage;

}  // namespace quell::cli
