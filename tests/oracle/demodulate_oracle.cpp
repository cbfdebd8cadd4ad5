#include "tests/oracle/demodulate_oracle.hpp"

#include "kernels/common/guides.h"

namespace quell::tests {

DemodulateExact demodulateOracle(const FrameImages& frame) {
  const Size size{frame.normal.width, frame.normal.height};
  const int signals = frame.material.signals();
  DemodulateExact exact{ExactPlanes(size, 3 * signals), ExactPlanes(size, QUELL_GUIDE_WEIGHT + signals),
                        ExactPlanes(size, 1), ExactPlanes(size, 1), BasicPlanes<char>(size, 1)};
  forEachPixel(size, [&](int x, int y) {
    bool undecided = false;
    const Surface surface = filteredSurfaceAt(frame, x, y, undecided);
    for (int signal = 0; signal < signals; ++signal) {
      const Material material = materialAt(frame.material, x, y, signal);
      undecided = undecided || material.undecided;
      if (!material.finite || !surface.valid || material.passesThrough(false)) continue;
      for (int c = 0; c < 3; ++c) exact.irradiance.at(3 * signal + c, x, y) = material.irradiance()[c];
      exact.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y) = 1.0;
    }
    for (int axis = 0; axis < 3; ++axis) {
      exact.guides.at(QUELL_GUIDE_POSITION + axis, x, y) = surface.position[axis];
      exact.guides.at(QUELL_GUIDE_NORMAL + axis, x, y) = surface.normal[axis];
    }
    exact.viewDepth.at(0, x, y) = viewDepthOf(frame, surface);
    if (!frame.roughness.empty()) exact.roughness.at(0, x, y) = roughnessAt(frame, x, y);
    exact.undecided.at(0, x, y) = undecided;
  });
  return exact;
}

}  // namespace quell::tests
