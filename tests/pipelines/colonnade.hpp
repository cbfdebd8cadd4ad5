// What tests of whole methods ask of data/colonnade, and of every picture.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "host/io/frame_sequence.hpp"
#include "host/metrics/report.hpp"
#include "tests/pipelines/signal_images.hpp"

namespace quell::tests {

/// Of the linear output of the last frame, against references through pixel centres.
inline metrics::ErrorFigures errorsOnColonnade(const Settings& settings) {
  const auto sequence = io::openSequence(std::string(QUELL_DATA_DIR) + "/colonnade");
  const auto reference = sequence->reference(15, io::ReferenceKind::Centre);
  return metrics::compareToReference(
      denoiseSequence(*sequence, sequence->frames(), settings).frames.back().linear, false, reference.a,
      reference.b);
}

/// Finite, not negative and not too bright.
inline void checkClean(const DenoisedSequence& result) {
  for (const cli::DenoisedFrame& frame : result.frames) {
    CHECK(isClean(frame.linear, kMostRadiance));
    CHECK(isClean(frame.display, 1.0f));
  }
}

}  // namespace quell::tests
