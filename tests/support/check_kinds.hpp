// What checks say about frames, in short.
#pragma once

#include <string>

#include "host/check/checks.hpp"
#include "host/cli/common/frame_views.hpp"

namespace quell::tests {

inline check::Result checked(const io::FrameData& now) {
  return check::checkFrame(cli::viewOf(now), nullptr);
}

/// The frame right before is given, too, if its number says that it is.
inline check::Result checked(const io::FrameData& before, const io::FrameData& now) {
  const check::Frame last = cli::viewOf(before);
  return check::checkFrame(cli::viewOf(now), &last);
}

/// Kinds of the findings of this severity and above, each with a blank behind it.
inline std::string kindsOf(const check::Result& result, Severity least = Severity::Note) {
  std::string kinds;
  for (const check::MappedFinding& found : result.findings)
    if (found.finding.severity >= least) kinds += found.finding.kind + " ";
  return kinds;
}

}  // namespace quell::tests
