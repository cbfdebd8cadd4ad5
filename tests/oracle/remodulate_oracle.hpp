// Double-precision oracle of the stage remodulate, see kernels/remodulate.cl.
#pragma once

#include "tests/oracle/demodulation_oracle.hpp"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct RemodulateInputs {
  MaterialImages material;
  Planes filtered;     ///< 3 planes a signal
  Planes guides;       ///< of the frame
  Planes lightGain{};  ///< of light_gain; empty: light is not given back
};

struct RemodulateExact {
  ExactPlanes linear;           ///< 3 planes
  ExactPlanes encoded;          ///< for display, 3 planes
  ExactPlanes magnitude;        ///< largest term of the pixel: what rounding errors are relative to, 1 plane
  BasicPlanes<char> undecided;  ///< pixels on which float and double may decide differently
};

RemodulateExact remodulateOracle(const RemodulateInputs& inputs);

}  // namespace quell::tests
