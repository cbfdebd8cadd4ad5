// Frames of a sequence as the checks see them.
#pragma once

#include <string>

#include "host/check/frame.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// Looks at an image that outlives the view.
check::Image viewOf(const io::Image& image);
check::Frame viewOf(const io::FrameData& frame);

/// Where the image of a finding comes from, for messages.
std::string fileOfImage(const io::FrameSequence& sequence, int frame, const std::string& image);

/// Kind of finding that a warning of the files is.
std::string kindOf(const io::FrameWarning& warning);

}  // namespace quell::cli
