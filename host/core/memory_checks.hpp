// Checks of the memory objects behind a frame's images, before anything is launched.
#pragma once

#include <quell/frame.hpp>

#include "host/core/opencl.hpp"

namespace quell {

/// Every present image must be a buffer of this context, large enough for its layout, or an image object that is as large
/// as the frame and has a format that stands for floats; outputs overlap nothing but linear radiance in place. For
/// `function`, which the caller called. Throws Error(InvalidArgument) or Error(WrongContext).
void checkMemory(const char* function, const Frame& frame, const Output& output, cl_context context);

/// What prepare() can know: the device has images if there are any; image objects that are given are as above, buffers large
/// enough, of whatever context. Throws so.
void checkKinds(const char* function, const Frame& frame, const Output& output, const cl::Device& device,
                cl_context context);

/// Fills in `pixelStrideBytes` of image objects whose memory is given: the bytes of a texel, for reports.
void resolveImageObjects(Frame& frame, Output& output);

/// Whether components have fewer bits than a float, be it in a buffer or in texels.
bool isNarrow(const ImageView& view);

}  // namespace quell
