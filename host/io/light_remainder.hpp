// Two signals: light that neither the diffuse nor the glossy passes explain.
#pragma once

#include "host/io/frame_sequence.hpp"

namespace quell::io {

/// Keeps what `frame.combined` has beyond albedo * radiance + gloss colour * glossyRadiance + emission: transmission,
/// subsurface scattering, volumes. On surfaces it joins the diffuse signal, whose albedo then has `transmissionColor` (3
/// channels, or empty) added, and is 1 where that sum is 0; on background it joins the emission. A frame that is explained
/// but for rounding stays as it is, bit by bit.
void keepRemainder(FrameData& frame, const Image& transmissionColor);

}  // namespace quell::io
