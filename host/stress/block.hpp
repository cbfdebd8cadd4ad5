// One block of pixels as a renderer hands it over, before anything is checked or clamped.
#pragma once

#include <array>
#include <vector>

#include "kernels/fit_params.h"

namespace quell::stress {

using Vector3 = std::array<double, 3>;

constexpr int kBlockEdge = QUELL_BLOCK_EDGE;
constexpr int kBlockPixels = QUELL_BLOCK_PIXELS;

/// Row-major, 32x32. Double precision here; stored as float or half when uploaded.
struct Block {
  std::array<Vector3, kBlockPixels> radiance{};          ///< linear, anything: also negative, NaN, Inf
  std::array<Vector3, kBlockPixels> normalWorld{};       ///< unit length; 0: sky
  std::array<Vector3, kBlockPixels> positionRelative{};  ///< relative to the camera, scene units
};

/// Blocks that are seen by one camera and uploaded in one format.
struct Batch {
  Vector3 cameraWorld{};    ///< world position of the camera; added to the positions before they are stored
  double unit = 1.0;        ///< positions, and the camera's, are multiplied by it first
  bool halfInputs = false;  ///< radiance, normal and position stored as halves
  std::vector<Block> blocks;
};

}  // namespace quell::stress
