#include "tests/cases/virtual_motion_case.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/common/guides.h"
#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

constexpr int kSignals = 2;
constexpr double kPixelTolerance = 1e-3 + 0.5 / QUELL_SUBPIXEL_STEPS;

// Between a hundredth of a unit and a hundred; a tenth of them not known, in one way or another.
float randomHit(Random& random) {
  constexpr float kUnknown[] = {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                                std::numeric_limits<float>::infinity(), 3e38f};
  if (random.uniform() < 0.1) return kUnknown[random.integer(0, 4)];
  return float(std::pow(10.0, random.uniform(-2.0, 2.0)));
}

StageSetup makeVirtualMotionSetup(const CaseOptions& options, bool parallel) {
  StageSetup setup = makeEdagiSetup(options);
  // The default camera is orthographic.
  if (!parallel) setup.frame.camera = makeCamera({}, movedCamera(), options.size);
  return setup;
}

Planes twice(const Planes& plane) {
  Planes both(plane.size(), kSignals);
  for (int signal = 0; signal < kSignals; ++signal)
    forEachPixel(plane.size(), [&](int x, int y) {
      both.at(signal, x, y) = signal == 1 ? plane.at(0, x, y) : float(QUELL_PREV_IN_FRAME);
    });
  return both;
}

}  // namespace

VirtualMotionCase::VirtualMotionCase(const CaseOptions& options, bool parallel)
    : StageCase("virtual_motion", makeVirtualMotionSetup(options, parallel)) {
  const Size size = options.size;
  inputs.guides = renderScene({}, size, kSignals, options.holes()).guides;
  inputs.guidesPrev = renderScene(movedCamera(), size, kSignals, options.holes()).guides;
  const RandomMotion path = randomMotion(size, options.seed);
  inputs.pixelPrev = path.pixelPrev;
  inputs.reprojectionMask = twice(path.reprojectionMask);
  inputs.hitDistance = io::Image(size.width, size.height, 1);
  Random random(options.seed + 1);
  for (float& hit : inputs.hitDistance.pixels) hit = randomHit(random);
  m_reprojection = makeReprojection({}, movedCamera(), size);
  inputs.reprojection = m_reprojection;
  inputs.parallel = parallel;
}

void VirtualMotionCase::upload() {
  m_harness.setInput(&Frame::hitDistance, inputs.hitDistance);
  m_harness.upload("guides", inputs.guides);
  m_harness.upload("guidesPrev", inputs.guidesPrev);
  m_harness.upload("pixelPrev", inputs.pixelPrev);
  m_harness.upload("reprojectionMask", inputs.reprojectionMask);
}

Comparison VirtualMotionCase::compare() {
  Comparison comparison(leftOut());
  const Planes pixels = pixelPrev(), masks = mask();
  const VirtualMotionExact exact = virtualMotionOracle(inputs, pixels);
  comparePixels(comparison, "position", positions(), exact.positions, leftOut());
  forEachPixel(size(), [&](int x, int y) {
    if (exact.undecided.at(0, x, y)) return comparison.exclude();
    for (int axis = 0; axis < 2; ++axis) {
      const double off = std::abs(pixels.at(axis, x, y) - exact.pixelPrev.at(axis, x, y));
      comparison.include("pixel", axis, x, y, std::max(0.0, off - kPixelTolerance), 0.0);
    }
    comparison.include("mask", 0, x, y, masks.at(0, x, y), exact.mask.at(0, x, y));
  });
  return comparison;
}

}  // namespace quell::tests
