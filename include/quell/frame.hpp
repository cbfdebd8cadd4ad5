// The buffer contract: what a renderer hands over for one frame and what it gets back.
#pragma once

#include <quell/frame_images.h>

#include <array>
#include <limits>
#include <quell/camera.hpp>
#include <quell/image_view.hpp>

namespace quell {

/// What the numbers of Frame::viewDepth mean. Those but View are converted in a pass of their own.
enum class DepthKind {
  View,          ///< along the view axis, scene units, positive in front
  NegativeView,  ///< the same with the sign of a view space whose axis points back (OpenGL's z)
  Ray,           ///< distance from the camera along the pixel's ray, scene units; perspective cameras
  Hyperbolic,    ///< depth buffer: 0 at the near plane, 1 at the far one
  Reversed,      ///< depth buffer: 1 at the near plane, 0 at the far one, which may be infinitely far
};

/// Inputs of one frame, in device memory that the caller owns; read until the event of denoise() has
/// completed. The images' layouts, `demodulated` and `depthKind` are fixed by prepare(); all else may change.
///
/// A pixel with NaN or Inf in radiance or emission is a missing sample: it keeps its history or is filled
/// from its surroundings. A pixel whose position or normal is not finite passes through unfiltered.
struct Frame {
  Size size;      ///< pixels, as prepared
  Camera camera;  ///< of this frame and the one before; where `motion` is given that says where things were

#define QUELL_VIEW(name, ...) ImageView name;
  /// What each holds, and which are optional, stands in frame_images.h.
  QUELL_FRAME_IMAGES(QUELL_VIEW)

  /// True where radiance is irradiance already: divided by albedo (glossyRadiance: by gloss colour), emission
  /// not included.
  bool demodulated = false;

  DepthKind depthKind = DepthKind::View;  ///< of `viewDepth`; of no meaning where that is absent
  /// Planes between which the depth buffers are spread out, scene units, 0 < near < far.
  double depthNear = 0.0;
  double depthFar = std::numeric_limits<double>::infinity();  ///< infinite: DepthKind::Reversed only

  /// What `motion` is multiplied by to be in pixels, x right, y down, previous minus current. For vectors in shares of the
  /// picture {width, height}, in NDC {0.5 * width, -0.5 * height}; the other sign where they point from previous to current.
  std::array<double, 2> motionScale{1.0, 1.0};

  /// How many samples images with Sum::OverSampleCount are the sums of, > 0.
  double sampleCount = 1.0;

  /// Dynamic resolution: the pixels that this frame renders, from pixel (0, 0) of every view on, 1x1 to `size`; {0, 0}: all
  /// of them. Only these are read and written; jitter, motion and `motionScale` are in pixels of this size. Where it is not
  /// that of the frame before, the history is resampled on the device, each pixel from the nearest one. A prepare() with
  /// any such size compiles what that takes, without which denoise() throws Error(NotPrepared). Rows that `rowPitchBytes`
  /// leaves open are as far apart as those of `size`; other pitches may change with this size.
  Size renderSize = {};
};

/// Half has a spacing of 1/64 scene units here; beyond, positions are too coarse to tell surfaces apart.
constexpr double kHalfPositionRange = 32.0;

/// Outputs of one frame, either or both; 3 or 4 channels (a fourth becomes 1). Every pixel is written, always
/// finite. `linear` may be the radiance image itself in the same layout; denoise() refuses every other overlap of an output
/// with an input or another output.
struct Output {
  QUELL_OUTPUT_IMAGES(QUELL_VIEW)
};
#undef QUELL_VIEW

}  // namespace quell
