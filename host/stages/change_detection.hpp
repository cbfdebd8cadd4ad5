// What the stages that follow changes of light share: their settings.
#pragma once

#include <quell/image_view.hpp>

#include "host/stages/tiles.hpp"
#include "kernels/change_params.h"

namespace quell {

struct ChangeDetection {
  double leastWeight = 0.2;            ///< least weight of the newest sample where nothing changes, (0, 1]
  double momentsLeastWeight = 0.2;     ///< the same for the moments
  double mostWeight = 1.0;             ///< largest weight of the newest sample, (0, 1]
  double threshold = 3.0;              ///< standard deviations below which a difference counts as noise
  double recentChangeThreshold = 1.0;  ///< the same where light has changed lately
  double gain = 4.0;      ///< excess of the squared deviation at which the weight is half of mostWeight
  double sumsKept = 0.4;  ///< share of the frame before in the sums, [0, 1)
};

ChangeParams makeChangeParams(const ChangeDetection& detection, Size size);

}  // namespace quell
