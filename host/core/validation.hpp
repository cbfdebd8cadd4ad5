// Checks of what the caller hands over, before anything is launched.
#pragma once

#include <quell/frame.hpp>

#include "host/core/opencl.hpp"

namespace quell {

/// Size and render size of a frame, for `function`, which the caller called. Throws Error(InvalidArgument).
void checkSizes(const char* function, const Frame& frame);

/// Layout rules of prepare(): sizes, required images, channels, strides, outputs.
/// Throws Error(InvalidArgument) naming the image.
void checkLayout(const Frame& frame, const Output& output);

/// The frame must have the size that was prepared, or a render size within it if that was prepared for. Throws
/// Error(NotPrepared) or Error(InvalidArgument).
void checkSameSize(const Frame& prepared, const Frame& frame);

/// What the frame renders (renderedPart()) must have the layouts that were prepared. Throws Error(NotPrepared).
void checkSameLayout(const Frame& prepared, const Output& preparedOutput, const Frame& frame,
                     const Output& output);

/// Numbers of a frame that are not a camera's: motionScale, sampleCount, depthNear, depthFar. Throws
/// Error(InvalidArgument).
void checkNumbers(const char* function, const Frame& frame);

/// The layouts and the memory of the inputs of what a frame renders, for `function`, which the caller called. Throws as
/// above.
void checkInputs(const char* function, const Frame& frame, cl_context context);

/// View depth is found along rays from one point. Throws Error(InvalidArgument) for other cameras.
void checkPerspective(const char* function, const Frame& frame);

/// Half positions are refused far from the world origin. Throws Error(OutOfRange).
void checkHalfPositions(const Frame& frame);

}  // namespace quell
