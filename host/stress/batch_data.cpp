#include "host/stress/batch_data.hpp"

namespace quell::stress {

Size imageSize(std::size_t blocks) { return {kBlockEdge, static_cast<int>(blocks) * kBlockEdge}; }

ReprojectionParams makeReprojection(const Batch& batch) {
  ReprojectionParams params{};
  float high[3], low[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double camera = batch.cameraWorld[axis] * batch.unit;
    high[axis] = static_cast<float>(camera);
    low[axis] = static_cast<float>(camera - static_cast<double>(high[axis]));
  }
  params.cameraHigh = {high[0], high[1], high[2], 0.0f};
  params.cameraLow = {low[0], low[1], low[2], 0.0f};
  return params;
}

}  // namespace quell::stress
