// A perspective camera from pixels and the surface points that they show.
#pragma once

#include <array>
#include <optional>
#include <quell/camera.hpp>
#include <string>
#include <vector>

namespace quell::io {

/// A pixel and what it shows.
struct CameraSample {
  std::array<double, 3> position;  ///< world, scene units
  double ndcX, ndcY;               ///< of the pixel's centre, y up
  double depth;                    ///< along the view axis, scene units, > 0
};

/// World to clip of a perspective camera (clip.w is the depth, row 2 is 0), or why there is none.
struct FoundCamera {
  std::optional<Matrix4> worldToClip;
  std::string failure;  ///< what the samples are instead; empty with a camera
};

/// clip.w is the depth, and clip.x = ndc.x * clip.w and clip.y are linear in the position, so three weighted
/// least-squares fits of four unknowns find the rows. Samples that a camera most others agree on puts elsewhere are left
/// out: least median of squares (Rousseeuw 1984) over small subsets, then fits to what is near. No camera where samples
/// are too few or all in one plane, or where none fits more than half of them to two pixels. `width` and `height` in
/// pixels. The same samples give the same camera.
FoundCamera fitCamera(const std::vector<CameraSample>& samples, int width, int height);

}  // namespace quell::io
