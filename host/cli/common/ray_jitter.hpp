// Whether a renderer sends its primary rays through pixel centres.
#pragma once

#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// Distance of a surface's position, projected into the image, from where the frame's camera says that rays go: mean over a
/// sample of the pixels, in pixels. 0 where there are no positions.
double rayOffsetPx(const io::FrameData& frame);

/// Whether the files say that rays are jittered, or the positions of the first frame show it: most renderers jitter every
/// sample and say so nowhere.
bool hasJitteredRays(const io::FrameSequence& sequence);

}  // namespace quell::cli
