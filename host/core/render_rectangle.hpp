// Dynamic resolution: frames that render a part of the prepared size, Frame::renderSize.
#pragma once

#include <quell/frame.hpp>

namespace quell {

inline bool hasRenderSize(const Frame& frame) { return frame.renderSize != Size{}; }

/// Pixels that the frame renders.
inline Size renderedSize(const Frame& frame) { return hasRenderSize(frame) ? frame.renderSize : frame.size; }

/// What a frame renders, as a frame of that size: rows of packed images stay as far apart as the whole size has them. The
/// same frame or output where no render size is given.
Frame renderedPart(const Frame& frame);
Output renderedPart(const Output& output, const Frame& frame);

}  // namespace quell
