// Views of captured frames: which bytes they cover.
#pragma once

#include <CL/cl.h>

#include "host/api/captured_frame.hpp"
#include "host/core/byte_range.hpp"

namespace quell {

bool isOutput(const CapturedView& view);

/// Adds all views of a frame that are present and the memory objects they lie in, without contents; the handles of these.
std::vector<cl_mem> captureViews(const Frame& frame, const Output& output, CapturedFrame& captured);

/// Whether an input lies in this memory object.
bool readsFrom(const CapturedFrame& captured, int memory);

/// Bytes of its memory object that a view covers; all of an image object.
ByteRange rangeOf(const CapturedView& view, const CapturedFrame& captured);

/// FNV-1a of the pixels, row by row from the top, without gaps; `bytes` are those of the range.
std::uint64_t pixelHash(const CapturedView& view, const CapturedFrame& captured, const Bytes& bytes);

}  // namespace quell
