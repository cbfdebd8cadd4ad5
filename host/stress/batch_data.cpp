#include "host/stress/batch_data.hpp"

#include "host/core/schedule.hpp"

namespace quell::stress {

Size imageSize(std::size_t blocks) { return {kBlockEdge, static_cast<int>(blocks) * kBlockEdge}; }

FitParams makeFitParams(std::size_t blocks, std::uint32_t noiseSeed, double noiseAmplitude) {
  FitParams params{};
  params.planes = makePlanes(imageSize(blocks));
  params.blocksX = 1;
  params.blocksY = static_cast<int>(blocks);
  params.noiseSeed = noiseSeed;
  params.noiseAmplitude = static_cast<float>(noiseAmplitude);
  return params;
}

GramParams makeGramParams(std::size_t blocks, double noiseAmplitude) {
  GramParams params{};
  params.planes = makePlanes(imageSize(blocks));
  params.tilesX = 1;
  params.tilesY = static_cast<int>(blocks);
  params.tileStride = params.tilesY;
  params.noiseVariance = static_cast<float>(noiseAmplitude * noiseAmplitude / 3.0);
  return params;
}

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
