#include "host/stages/light_sums.hpp"

#include "host/core/frame_images.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(LightSumsOptions, LIGHT_SUMS)

LightSums::LightSums(const Configuration& configuration) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  lightTiles = tileCount(configuration.size(), QUELL_SIGNALS);
}

}  // namespace quell
