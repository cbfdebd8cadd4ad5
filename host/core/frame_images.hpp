// The caller's images as groups that several stages read.
#pragma once

#include <quell/frame.hpp>
#include <string>

#include "host/core/stage.hpp"
#include "kernels/common/material_params.h"
#include "kernels/common/motion_params.h"
#include "kernels/common/surface_params.h"

namespace quell {

/// Signals that are filtered: 2 where the caller gives glossy radiance apart, else 1.
inline int signalCount(const Frame& frame) { return frame.glossyRadiance.present() ? 2 : 1; }

/// World position, or view depth where that is given instead.
inline const ImageView& positionView(const Frame& frame) {
  return frame.positionWorld.present() ? frame.positionWorld : frame.viewDepth;
}

/// True if the setting `demodulate` asks for F_beta. Throws Error(InvalidArgument) without a roughness image.
bool dividesByFBeta(const Configuration& configuration);

/// Compile options for light and what it is divided by, as the setting `demodulate` says.
std::string materialOptions(const Configuration& configuration);
MaterialParams makeMaterialParams(const Frame& frame, const ReprojectionParams& reprojection);
/// Bytes of light and what it is divided by.
std::uint64_t materialBytes(const Frame& frame);
/// Bytes of what F_beta is looked up with, if that is asked for.
std::uint64_t fBetaBytes(const Configuration& configuration);

/// Compile options for normal and position.
std::string surfaceOptions(const Frame& frame);
SurfaceParams makeSurfaceParams(const Frame& frame);

/// Whether this frame or the one before was sampled off the pixel centres.
bool isJittered(const Camera& camera);

/// Compile options for motion vectors and object ids.
std::string motionOptions(const Frame& frame);
MotionParams makeMotionParams(const Frame& frame);
/// Bytes of motion vectors and object ids.
std::uint64_t motionBytes(const Frame& frame);

}  // namespace quell
