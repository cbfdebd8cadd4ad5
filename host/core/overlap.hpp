// Which images lie in the same memory.
#pragma once

#include <quell/frame.hpp>

namespace quell {

/// An output shares no byte with an input or the other output, by handles, parts of buffers and ranges; the linear output
/// may be the radiance in the same layout. The memory of all present images is that of valid objects. Throws
/// Error(InvalidArgument) naming the output and what it overlaps.
void checkOverlaps(const char* function, const Frame& frame, const Output& output);

}  // namespace quell
