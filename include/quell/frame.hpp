// The buffer contract: what a renderer hands over for one frame and what it gets back.
#pragma once

#include <quell/frame_images.h>

#include <quell/camera.hpp>
#include <quell/image_view.hpp>

namespace quell {

/// Inputs of one frame, in device memory that the caller owns; read until the event of denoise() has
/// completed.
///
/// A pixel with NaN or Inf in radiance or emission is a missing sample: it keeps its history or is filled
/// from its surroundings. A pixel whose position or normal is not finite passes through unfiltered.
struct Frame {
  Size size;
  Camera camera;

#define QUELL_VIEW(name, ...) ImageView name;
  /// What each holds, and which are optional, stands in frame_images.h.
  QUELL_FRAME_IMAGES(QUELL_VIEW)

  /// True where radiance is irradiance already: divided by albedo (glossyRadiance: by gloss colour), emission
  /// not included.
  bool demodulated = false;
};

/// Half has a spacing of 1/64 scene units here; beyond, positions are too coarse to tell surfaces apart.
constexpr double kHalfPositionRange = 32.0;

/// Outputs of one frame, either or both; 3 or 4 channels (a fourth becomes 1). Every pixel is written, always
/// finite. `linear` may be the radiance image itself in the same layout; no other overlap with an input.
struct Output {
  QUELL_OUTPUT_IMAGES(QUELL_VIEW)
};
#undef QUELL_VIEW

}  // namespace quell
