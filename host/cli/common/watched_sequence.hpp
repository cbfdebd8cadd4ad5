// Sequences that say on standard error what is odd about their frames.
#pragma once

#include <memory>
#include <string>

#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// io::openSequence(), and whatever reads from it prints the first warning of each kind: those of the frames themselves, and
/// what checks (docs/check.md) find doubtful or wrong in the first frames that are read. Frames whose noise and view stay
/// the same have `repeatsNoise` set. It counts as jittered also where nothing but the positions of its first frame show it.
std::unique_ptr<io::FrameSequence> openWatched(const std::string& path,
                                               const io::SequenceOptions& options = {});

}  // namespace quell::cli
