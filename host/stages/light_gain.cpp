#include "host/stages/light_gain.hpp"

#include "host/core/frame_images.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(LightGainOptions, LIGHT_GAIN)

LightGain::LightGain(const Configuration& configuration) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  lightTiles = tileCount(configuration.size(), QUELL_SIGNALS);
}

}  // namespace quell
