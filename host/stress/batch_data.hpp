// What the device gets of a batch: camera and pixels.
#pragma once

#include <array>
#include <cstdint>
#include <quell/frame.hpp>
#include <vector>

#include "host/stress/block.hpp"
#include "kernels/common/reprojection_params.h"

namespace quell::stress {

/// Blocks one below the other.
Size imageSize(std::size_t blocks);

/// No history; positions become relative to the camera as host/core/reprojection.cpp arranges it.
ReprojectionParams makeReprojection(const Batch& batch);

/// Values of one image in the order of its pixels, packed.
template <class Value>
std::vector<Value> packImage(const Batch& batch, std::array<Vector3, kBlockPixels> Block::*image) {
  const bool isPosition = image == &Block::positionRelative;
  std::vector<Value> values;
  values.reserve(batch.blocks.size() * kBlockPixels * 3);
  for (const Block& block : batch.blocks)
    for (const Vector3& pixel : block.*image)
      for (std::size_t c = 0; c < 3; ++c)
        values.push_back(static_cast<Value>(
            static_cast<float>(isPosition ? (pixel[c] + batch.cameraWorld[c]) * batch.unit : pixel[c])));
  return values;
}

}  // namespace quell::stress
