#include <limits>

#include "tests/cases/background_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker() {
  return [](const CaseOptions& options) { return std::make_unique<BackgroundCase>(options); };
}

}  // namespace

TEST_CASE("background agrees with its oracle") { checkSizes(maker()); }

TEST_CASE("background reads and writes other layouts") { checkLayouts(maker(), {packedHalf(4)}); }

TEST_CASE("background leaves alone what has a surface") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    BackgroundCase background(options);
    background.uploadAndRun();
    const Planes denoised = background.denoised(), antialiased = background.antialiased();
    std::size_t touched = 0;
    forEachPixel(options.size, [&](int x, int y) {
      if (background.isBackground(x, y)) return;
      touched += denoised.at(0, x, y) != -1.0f || antialiased.at(0, x, y) != -1.0f;
    });
    CHECK(touched == 0);
  }
}

TEST_CASE("background is finite for any input") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    BackgroundCase background(options);
    const std::vector<float> values = adversarialValues();
    Random random(3);
    for (io::Image* image : {&background.inputs.radiance, &background.inputs.emission})
      for (float& value : image->pixels)
        value = values[std::size_t(random.integer(0, int(values.size()) - 1))];
    checkAgreement(background, options);
  }
}
