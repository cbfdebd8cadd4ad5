#include "host/core/frame_images.hpp"

#include <quell/error.hpp>

namespace quell {

bool dividesByFBeta(const Configuration& configuration) {
  return configuration.runtime.demodulation == Demodulation::FBeta;
}

void requireFBetaImages(const Configuration& configuration) {
  if (dividesByFBeta(configuration) && !configuration.frame.roughness.present())
    throw Error(ErrorCode::InvalidArgument,
                {"prepare", "roughness", "an image, since light is divided by F_beta", "none"});
}

}  // namespace quell
