// Double-precision oracle of the stage material_guides, see kernels/material_guides.cl.
#pragma once

#include "host/io/image.hpp"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct MaterialGuidesInputs {
  io::Image albedo;     ///< as the device sees it: rounded to its format; 1, 3 or 4 channels
  io::Image roughness;  ///< 1 channel
};

/// 4 planes: albedo and roughness, clamped; 0 where not finite.
ExactPlanes materialGuidesOracle(const MaterialGuidesInputs& inputs);

}  // namespace quell::tests
