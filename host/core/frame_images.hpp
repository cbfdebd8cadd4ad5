// The caller's images, and what follows from which of them there are.
#pragma once

#include <quell/frame.hpp>
#include <string>

#include "host/core/schedule.hpp"

namespace quell {

/// Signals that are filtered: 2 where the caller gives glossy radiance apart, else 1.
inline int signalCount(const Frame& frame) { return frame.glossyRadiance.present() ? 2 : 1; }

/// True if light is divided by F_beta, too.
bool dividesByFBeta(const Configuration& configuration);
/// Throws Error(InvalidArgument) if that is asked for without a roughness image.
void requireFBetaImages(const Configuration& configuration);

}  // namespace quell
