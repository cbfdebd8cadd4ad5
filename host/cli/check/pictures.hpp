// Pictures of what a check found.
#pragma once

#include <string>

#include "host/check/context.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// The image that the finding is about, made visible, and beside it where the finding is, bright, if it is about single
/// pixels; 3 channels, display-encoded.
io::Image pictureOf(const io::FrameData& frame, const check::MappedFinding& found);

}  // namespace quell::cli
