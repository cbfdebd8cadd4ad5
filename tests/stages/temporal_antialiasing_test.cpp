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

TEST_CASE("temporal_antialiasing writes the linear image where rays are jittered") {
  checkVariants(
      {[](const CaseOptions& options) { return std::make_unique<TemporalAntialiasingCase>(options, true); }});
}

TEST_CASE("temporal_antialiasing leaves out background") { checkHoles(make); }

TEST_CASE("temporal_antialiasing does not depend on the work-group") {
  checkWorkGroups(make, {"antialiased"});
}

TEST_CASE("temporal_antialiasing of a constant is constant whatever the history") {
  for (const CaseOptions& options : bothMappings()) {
    TemporalAntialiasingCase taa(options);
    taa.inputs.denoised = constantColor(options.size, 0.25f, 0.5f, 0.875f);
    taa.uploadAndRun();
    const Planes result = taa.antialiased();
    forEachPixel(options.size, [&](int x, int y) {
      CHECK(result.at(0, x, y) == Approx(0.25).margin(kTemporalAntialiasingTolerance));
      CHECK(result.at(1, x, y) == Approx(0.5).margin(kTemporalAntialiasingTolerance));
      CHECK(result.at(2, x, y) == Approx(0.875).margin(kTemporalAntialiasingTolerance));
    });
  }
}

TEST_CASE("temporal_antialiasing takes history from where the nearest surface was, be it the neighbour's") {
  for (const CaseOptions& options : bothMappings()) {
    TemporalAntialiasingCase taa(options);
    fill(taa.inputs.viewDepth, 3.0f);
    fill(taa.inputs.reprojectionMask, QUELL_PREV_IN_FRAME | 15);
    // A ramp over the columns, which the clamp leaves as it is: what is behind stands still, a column in front of it has
    // moved by half a pixel.
    forEachPixel(options.size, [&](int x, int y) {
      for (int c = 0; c < 3; ++c) {
        taa.inputs.denoised.at(c, x, y) = (x + y) % 2 == 0 ? 0.0f : 1000.0f;
        taa.inputs.antialiasedPrev.at(c, x, y) = float(100 + x);
      }
      taa.inputs.pixelPrev.at(0, x, y) = float(x) - (x == 16 ? 0.5f : 0.0f);
      taa.inputs.pixelPrev.at(1, x, y) = float(y);
      if (x == 16) taa.inputs.viewDepth.at(0, x, y) = 1.0f;
    });
    taa.uploadAndRun();
    const Planes result = taa.antialiased();
    for (const int x : {14, 15, 16, 17, 18}) {
      const bool silhouette = x >= 15 && x <= 17;
      const double moved = silhouette ? 0.5 : 0.0;
      const double weight = silhouette ? taa.inputs.silhouetteWeight : taa.inputs.newestWeight;
      const double newest = taa.inputs.denoised.at(0, x, 10);
      CHECK(result.at(0, x, 10) ==
            Approx(weight * newest + (1.0 - weight) * (100.0 + x - moved)).epsilon(1e-5));
    }
  }
}

TEST_CASE("temporal_antialiasing keeps the newest colour where there was no frame before") {
  CaseOptions options;
  TemporalAntialiasingCase taa(options);
  for (float& mask : taa.inputs.reprojectionMask.values) mask = float(int(mask) & ~QUELL_PREV_IN_FRAME);
  taa.uploadAndRun();
  CHECK(sameBits(taa.antialiased(), taa.inputs.denoised));
}

TEST_CASE("temporal_antialiasing takes no history where accumulation took none, silhouettes apart") {
  for (const CaseOptions& options : bothMappings()) {
    TemporalAntialiasingCase taa(options);
    const int lastRejected = 12;
    forEachPixel(options.size, [&](int x, int y) {
      taa.inputs.pixelPrev.at(0, x, y) = float(x);
      taa.inputs.pixelPrev.at(1, x, y) = float(y);
      const bool rejected = x <= lastRejected || x == 20;  // an area and a silhouette
      taa.inputs.reprojectionMask.at(0, x, y) =
          QUELL_PREV_IN_FRAME | (rejected ? QUELL_HISTORY_REJECTED : QUELL_TAP_ACCEPTED(0));
    });
    checkAgreement(taa, options);
    const Planes result = taa.antialiased();
    std::size_t kept = 0, blended = 0;
    forEachPixel(options.size, [&](int x, int y) {
      const bool newest = result.at(0, x, y) == taa.inputs.denoised.at(0, x, y);
      (x < lastRejected ? kept : blended) += newest == (x < lastRejected);
    });
    CHECK(kept == std::size_t(lastRejected * options.size.height));
    CHECK(blended > std::size_t((options.size.width - lastRejected) * options.size.height * 3 / 4));
  }
}

TEST_CASE("temporal_antialiasing without motion blends by the weight of the newest frame") {
  // A checkerboard: all colours of the history lie within the bounds of every neighbourhood.
  CaseOptions options;
  TemporalAntialiasingCase taa(options);
  fill(taa.inputs.viewDepth, 3.0f);
  forEachPixel(options.size, [&](int x, int y) {
    taa.inputs.pixelPrev.at(0, x, y) = float(x);
    taa.inputs.pixelPrev.at(1, x, y) = float(y);
    taa.inputs.reprojectionMask.at(0, x, y) = QUELL_PREV_IN_FRAME;
    for (int c = 0; c < 3; ++c) {
      taa.inputs.denoised.at(c, x, y) = float((x + y) % 2);
      taa.inputs.antialiasedPrev.at(c, x, y) = 0.5f;
    }
  });
  taa.uploadAndRun();
  const Planes result = taa.antialiased();
  forEachPixel(options.size, [&](int x, int y) {
    const double expected = taa.inputs.newestWeight * ((x + y) % 2) + (1.0 - taa.inputs.newestWeight) * 0.5;
    CHECK(result.at(1, x, y) == Approx(expected).margin(kTemporalAntialiasingTolerance));
  });
}
