#include "host/stages/change_tiles.hpp"

#include "host/core/schedule.hpp"

namespace quell {
namespace {

int tilesAlong(int pixels) { return (pixels + QUELL_CHANGE_TILE - 1) / QUELL_CHANGE_TILE; }

}  // namespace

ChangeParams makeChangeParams(const ChangeDetection& detection, Size size) {
  ChangeParams params{};
  params.planes = makePlanes(size);
  params.tilesX = tilesAlong(size.width);
  params.tilesY = tilesAlong(size.height);
  params.sumsKept = static_cast<float>(detection.sumsKept);
  params.thresholdSquared = static_cast<float>(detection.threshold * detection.threshold);
  params.recentChangeThresholdSquared =
      static_cast<float>(detection.recentChangeThreshold * detection.recentChangeThreshold);
  params.gain = static_cast<float>(detection.gain);
  params.leastWeight = static_cast<float>(detection.leastWeight);
  params.momentsLeastWeight = static_cast<float>(detection.momentsLeastWeight);
  params.mostWeight = static_cast<float>(detection.mostWeight);
  return params;
}

std::array<std::size_t, 2> tileRange(const ChangeParams& params) {
  return {static_cast<std::size_t>(params.tilesX), static_cast<std::size_t>(params.tilesY)};
}

int changeTileCount(Size size, int signals) {
  return tilesAlong(size.width) * tilesAlong(size.height) * signals;
}

}  // namespace quell
