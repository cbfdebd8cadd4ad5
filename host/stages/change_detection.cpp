#include "host/stages/change_detection.hpp"

#include "host/core/schedule.hpp"

namespace quell {

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

}  // namespace quell
