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

bool isJittered(const Camera& camera) {
  const std::array<double, 2> centred{0.0, 0.0};
  return camera.jitterPx != centred || camera.jitterPxPrev != centred;
}

}  // namespace quell
