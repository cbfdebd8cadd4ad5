#include <algorithm>

#include "kernels/accumulate_noisy_params.h"
#include "tests/cases/temporal_antialiasing_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

std::unique_ptr<StageCase> make(const CaseOptions& options) {
  return std::make_unique<TemporalAntialiasingCase>(options);
}

Planes constantColor(Size size, float red, float green, float blue) {
  Planes planes(size, 3);
  forEachPixel(size, [&](int x, int y) {
    planes.at(0, x, y) = red;
    planes.at(1, x, y) = green;
    planes.at(2, x, y) = blue;
  });
  return planes;
}

}  // namespace

TEST_CASE("temporal_antialiasing agrees with its oracle") { checkSizes(make); }

TEST_CASE("temporal_antialiasing writes every layout of the display image") {
  checkLayouts(make, outputLayouts());
}

TEST_CASE("temporal_antialiasing leaves out background") { checkHoles(make); }

TEST_CASE("temporal_antialiasing does not depend on the work-group") {
  checkWorkGroups(make, {"antialiased"});
}

TEST_CASE("temporal_antialiasing of a constant is constant whatever the history") {
  for (const CaseOptions& options : bothMappings()) {
    TemporalAntialiasingCase taa(options);
    taa.inputs.encoded = constantColor(options.size, 0.25f, 0.5f, 0.875f);
    taa.uploadAndRun();
    const Planes result = taa.antialiased();
    forEachPixel(options.size, [&](int x, int y) {
      CHECK(result.at(0, x, y) == Approx(0.25).margin(kTemporalAntialiasingTolerance));
      CHECK(result.at(1, x, y) == Approx(0.5).margin(kTemporalAntialiasingTolerance));
      CHECK(result.at(2, x, y) == Approx(0.875).margin(kTemporalAntialiasingTolerance));
    });
  }
}

TEST_CASE("temporal_antialiasing keeps the newest colour where there was no frame before") {
  CaseOptions options;
  TemporalAntialiasingCase taa(options);
  for (float& mask : taa.inputs.reprojectionMask.values) mask = float(int(mask) & ~QUELL_PREV_IN_FRAME);
  taa.uploadAndRun();
  CHECK(sameBits(taa.antialiased(), taa.inputs.encoded));
}

TEST_CASE("temporal_antialiasing without motion blends by the weight of the newest frame") {
  // A checkerboard: all colours of the history lie within the bounds of every neighbourhood.
  CaseOptions options;
  TemporalAntialiasingCase taa(options);
  forEachPixel(options.size, [&](int x, int y) {
    taa.inputs.pixelPrev.at(0, x, y) = float(x);
    taa.inputs.pixelPrev.at(1, x, y) = float(y);
    taa.inputs.reprojectionMask.at(0, x, y) = QUELL_PREV_IN_FRAME;
    for (int c = 0; c < 3; ++c) {
      taa.inputs.encoded.at(c, x, y) = float((x + y) % 2);
      taa.inputs.antialiasedPrev.at(c, x, y) = 0.5f;
    }
  });
  taa.uploadAndRun();
  const Planes result = taa.antialiased();
  forEachPixel(options.size, [&](int x, int y) {
    const double expected = 0.2 * ((x + y) % 2) + 0.8 * 0.5;
    CHECK(result.at(1, x, y) == Approx(expected).margin(kTemporalAntialiasingTolerance));
  });
}
