// Checks of what the caller hands over, before anything is launched.
#pragma once

#include <quell/frame.hpp>

#include "host/core/opencl.hpp"

namespace quell {

/// Layout rules of prepare(): sizes, required images, channels, strides, outputs.
/// Throws Error(InvalidArgument) naming the image.
void checkLayout(const Frame& frame, const Output& output);

/// The frame must have the size and layouts that were prepared. Throws Error(NotPrepared).
void checkSameLayout(const Frame& prepared, const Output& preparedOutput, const Frame& frame,
                     const Output& output);

/// Every present image must be a buffer of this context, large enough for its layout.
/// Throws Error(InvalidArgument) or Error(WrongContext).
void checkMemory(const Frame& frame, const Output& output, cl_context context);

/// The layouts and the memory of the inputs alone, for `function`, which the caller called. Throws as above.
void checkInputs(const char* function, const Frame& frame, cl_context context);

/// Half positions are refused far from the world origin. Throws Error(OutOfRange).
void checkHalfPositions(const Frame& frame);

}  // namespace quell
