#include "host/stages/gram_windows.hpp"

#include "host/stages/fit.hpp"

namespace quell {
namespace {

// One more than cover the image, for the displacement.
int tilesAlong(int pixels, int edge) { return (pixels + edge - 1) / edge + 1; }

int tileCount(const GramParams& params) { return params.tilesX * params.tilesY; }

}  // namespace

GramParams makeGramParams(const GramWindows& windows, Size size, std::uint32_t frameIndex,
                          double noiseAmplitude) {
  GramParams params{};
  params.planes = makePlanes(size);
  // Tiles follow the displacement of the blocks, so that no grid stands still while frames accumulate.
  const FitParams blocks = makeFitParams(size, frameIndex, 0.0);
  params.tileOffsetX = windows.overlap ? blocks.blockOffsetX % windows.tileEdge : blocks.blockOffsetX;
  params.tileOffsetY = windows.overlap ? blocks.blockOffsetY % windows.tileEdge : blocks.blockOffsetY;
  params.tilesX = tilesAlong(size.width, windows.tileEdge);
  params.tilesY = tilesAlong(size.height, windows.tileEdge);
  params.tileStride = tileCount(params);
  params.noiseVariance = static_cast<float>(noiseAmplitude * noiseAmplitude / 3.0);
  return params;
}

int gramTileFloats(const GramWindows& windows, Size size, const FitFeatures& features) {
  return tileCount(makeGramParams(windows, size, 0, 0.0)) * features.gramPlanes(windows.overlap);
}

int gramRecordFloats(const GramWindows& windows, Size size, const FitFeatures& features) {
  return tileCount(makeGramParams(windows, size, 0, 0.0)) * features.recordSize();
}

}  // namespace quell
