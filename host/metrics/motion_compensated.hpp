// Flicker between consecutive frames under a moving camera.
#pragma once

#include <optional>
#include <quell/camera.hpp>

#include "host/io/image.hpp"

namespace quell::metrics {

/// One frame as the measure needs it; all images have one size, and 3 channels unless said otherwise.
struct TrackedFrame {
  io::Image encoded;        ///< the denoised picture, display-encoded
  io::Image normalWorld;    ///< unit length, zero marks background
  io::Image positionWorld;  ///< scene units
  Camera camera;            ///< matrices of this frame and of the one before
  io::Image motion;         ///< 2 channels, pixels: previous pixel minus this one, x right, y down; optional
  io::Image objectId;       ///< 1 channel; optional
  bool afterCut = false;    ///< the frame before is none of the same view
};

/// Largest distance between a surface point and the one found for it in the frame before, as a share of clip.w
/// there. Source: a few pixel footprints at the sizes of the test sequences.
constexpr double kSameSurfaceShare = 0.01;
/// Least cosine between their normals.
constexpr double kSameSurfaceCosine = 0.9;
/// Largest change of clip.w of a surface that has moved, as a share of what it would be at rest.
constexpr double kMovedDepthShare = 0.1;
/// A surface has moved where its motion vector leads farther than this from where the matrices do, pixels.
constexpr double kMovedPx = 0.25;

/// Motion-compensated temporal error: the mean of |luma(pixel) - luma(same surface point, frame before)|, Rec. 709,
/// display-encoded, over the pixels whose surface all four bilinear taps of the frame before show. For a static
/// view this is the plain temporal error without background. Moving objects count where there are motion vectors and
/// object ids: their surface is the same if the object is, and normals and depth are near. Otherwise they count as not
/// visible before.
class MotionCompensatedErrorMeter {
 public:
  /// Throws Error(InvalidArgument) for images without their channels or of different sizes.
  void add(TrackedFrame frame);

  /// The mean over all pairs of frames; nothing before the second one, or where no surface was seen twice.
  std::optional<double> mean() const;

 private:
  TrackedFrame m_last;
  double m_sum = 0.0;
  double m_count = 0.0;
};

}  // namespace quell::metrics
