// Double-precision oracle of the stage demodulate, see kernels/demodulate.cl.
#pragma once

#include "tests/oracle/surface_oracle.hpp"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct DemodulateExact {
  ExactPlanes irradiance, guides, viewDepth;
  ExactPlanes roughness;        ///< 0 where the frame has none
  BasicPlanes<char> undecided;  ///< pixels on which float and double may decide differently
};

DemodulateExact demodulateOracle(const FrameImages& frame);

}  // namespace quell::tests
