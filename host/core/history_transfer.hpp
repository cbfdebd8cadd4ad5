// A history that outlives a change of size or settings.
#pragma once

#include "host/core/pipeline.hpp"

namespace quell {

/// Fills the histories of `to`, as frames of this parity write them, with those of `from`, which must be done; blocks. After
/// a change of size every pixel takes what the nearest one had, plane by plane, so that its position, normal, light and
/// length stay together, through host memory. Sums over tiles start afresh then. False, with unknown contents, unless all
/// pixels could be kept.
bool carryHistory(const cl::CommandQueue& queue, const Pipeline& from, const Pipeline& to, int parity);

/// As bytes: pixels at `newSize` from those of a buffer at `oldSize`.
std::vector<unsigned char> resampleNearest(const std::vector<unsigned char>& old, const BufferSpec& spec,
                                           Size oldSize, Size newSize);

}  // namespace quell
