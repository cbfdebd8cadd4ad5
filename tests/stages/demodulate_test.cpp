#include "kernels/common/guides.h"
#include "tests/cases/demodulate_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

const FrameVariant kEverything{kTwoSignals, false, true};

CaseMaker maker(const FrameVariant& variant) {
  return [variant](const CaseOptions& options) { return std::make_unique<DemodulateCase>(options, variant); };
}

}  // namespace

TEST_CASE("demodulate agrees with its oracle") { checkSizes(maker(kEverything)); }

TEST_CASE("demodulate agrees with its oracle whichever images there are") {
  checkVariants({maker({kPlainMaterial, true}), maker({kUndividedMaterial}),
                 maker({kTwoDemodulatedSignals, true, true})});
}

TEST_CASE("demodulate divides by F_beta as its oracle does") {
  checkSizes(maker({kTwoFBetaSignals, false, true}));
  checkLayouts(maker({kFBetaMaterial, true, true}), {packedHalf(4)});
}

TEST_CASE("demodulate finds background") {
  checkHoles(maker(kEverything));
  checkHoles(maker({kFBetaMaterial, true, true}));
}

TEST_CASE("demodulate reads two signals of half precision") {
  checkLayouts(maker(kEverything), {packedHalf(4)});
}

TEST_CASE("demodulate does not depend on the work-group") {
  checkWorkGroups(maker(kEverything), {"irradiance", "guides", "viewDepth", "roughness"});
}

TEST_CASE("demodulate gives finite values for any input, and bad pixels do not leak") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    DemodulateCase demodulate(options, kEverything);
    demodulate.uploadAndRun();
    const Planes irradiance = demodulate.irradiance(), guides = demodulate.guides();
    BasicPlanes<char> spoiled(options.size, 1);
    auto& inputs = demodulate.inputs;
    auto& material = inputs.material;
    unsigned seed = 7;
    for (io::Image* image :
         {&material.radiance, &material.glossyRadiance, &material.emission, &material.albedo,
          &material.glossColor, &inputs.normal, &inputs.position, &inputs.roughness})
      spoil(*image, seed++, 16, &spoiled);
    checkAgreement(demodulate, options);
    CHECK(allFinite(demodulate.irradiance()));
    CHECK(allFinite(demodulate.guides()));
    CHECK(sameBits(irradiance, demodulate.irradiance(), &spoiled));
    CHECK(sameBits(guides, demodulate.guides(), &spoiled));
  }
}
