// Errors as colours.
#pragma once

#include "host/io/image.hpp"

namespace quell::metrics {

/// A 1-channel map of values in [0, 1] as a display-encoded RGB picture: black, violet, red, orange, pale
/// yellow, with luma rising evenly so that it still reads in grey. Values outside are clamped; NaN becomes
/// pure green.
io::Image colorizeMap(const io::Image& map);

}  // namespace quell::metrics
