// Sequences that say on standard error what is odd about their frames.
#pragma once

#include <memory>
#include <string>

#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// io::openSequence(), and whatever reads from it prints the first warning of each kind: those of the frames themselves,
/// normals that are not as the contract says (normal_check.hpp), noise that stays the same (noise_watch.hpp; such frames
/// have `repeatsNoise` set). It counts as jittered also where nothing but the positions of its first frame show it
/// (ray_jitter.hpp).
std::unique_ptr<io::FrameSequence> openWatched(const std::string& path,
                                               const io::SequenceOptions& options = {});

}  // namespace quell::cli
