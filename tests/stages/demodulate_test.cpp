#include <array>
#include <iterator>
#include <limits>

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

// One signal with albedo and no emission image; what is no emitter is noise.
const FrameVariant kAlbedoAlone{{false, true}};

Planes normalsOf(const Planes& guides) { return planesOf(guides, QUELL_GUIDE_NORMAL, 3); }

Planes weightsOf(const DemodulateCase& demodulate, int signal = 0) {
  return planesOf(demodulate.guides(), QUELL_GUIDE_WEIGHT + signal, 1);
}

bool isInLamp(int x, int y) { return x >= 14 && x < 21 && y >= 6 && y < 9; }

// Black pixels in a lamp, which shows in radiance and, where there is such an image, in emission.
void addLamp(MaterialImages& material) {
  forEachPixel({material.radiance.width, material.radiance.height}, [&](int x, int y) {
    for (int c = 0; c < 3; ++c) {
      if (!isInLamp(x, y)) continue;
      if (!material.emission.empty()) material.emission.at(x, y, c) = 5.0f;
      material.albedo.at(x, y, c) = 0.0f;
      material.radiance.at(x, y, c) = 5.0f;
    }
  });
}

struct Divided {
  Vector3d albedo;
  Vector3d divisor;
  std::array<bool, 3> weak;
};

}  // namespace

TEST_CASE("demodulate agrees with its oracle") { checkSizes(maker(kEverything)); }

TEST_CASE("demodulate agrees with its oracle whichever images there are") {
  checkVariants({maker({kPlainMaterial, true}), maker({kUndividedMaterial}), maker({kMaterialWithF0}),
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

TEST_CASE("demodulate divides by what is known of a material, and tells kinds of materials apart") {
  const double most = 2.0, nan = std::numeric_limits<double>::quiet_NaN();
  const Divided materials[] = {{{0.8, 0.4, 0.2}, {0.8, 0.4, 0.2}, {}},
                               {{1.5, 50.0, 1e30}, {1.5, most, most}, {}},
                               {{0.8, 0.0, 0.0}, {0.8, 0.8, 0.8}, {false, true, true}},
                               {{0.009, 0.4, 1e-7}, {0.4, 0.4, 0.4}, {true, false, true}},
                               {{nan, -0.5, 0.5}, {0.5, 0.5, 0.5}, {true, true, false}},
                               {{0.5, 0.0, 0.5}, {0.5, 0.5, 0.5}, {false, true, false}},
                               {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {true, true, true}},
                               {{0.009, 1e-7, 1e-30}, {1.0, 1.0, 1.0}, {true, true, true}},
                               {{-0.5, nan, 0.0}, {1.0, 1.0, 1.0}, {true, true, true}}};
  for (const CaseOptions& options : bothMappings()) {
    DemodulateCase plain(options, kAlbedoAlone), demodulate(options, kAlbedoAlone);
    for (float& value : plain.inputs.material.albedo.pixels) value = 1.0f;
    const auto materialAt = [&](int x, int y) {
      return materials[std::size_t(x + 5 * y) % std::size(materials)];
    };
    forEachPixel(options.size, [&](int x, int y) {
      for (int c = 0; c < 3; ++c)
        demodulate.inputs.material.albedo.at(x, y, c) = float(materialAt(x, y).albedo[c]);
    });
    plain.uploadAndRun();
    demodulate.uploadAndRun();
    const Planes normals = normalsOf(plain.guides()), filtered = normalsOf(demodulate.guides());
    const Planes radiance = plain.irradiance(), irradiance = demodulate.irradiance();
    CHECK(sameBits(weightsOf(demodulate), weightsOf(plain)));
    forEachPixel(options.size, [&](int x, int y) {
      const Divided material = materialAt(x, y);
      Vector3d normal, turned;
      for (int c = 0; c < 3; ++c) {
        CHECK(irradiance.at(c, x, y) == Approx(radiance.at(c, x, y) / material.divisor[c]).epsilon(1e-6));
        normal[c] = normals.at(c, x, y);
        turned[c] = filtered.at(c, x, y);
      }
      CHECK((turned - turnedNormal(normal, material.weak)).norm() == 0.0);
      if (material.weak != std::array<bool, 3>{}) CHECK(turned.dot(normal) <= 0.5 + 1e-6);
    });
  }
}

TEST_CASE("demodulate leaves out emitters, known by emission or by colour without noise, but no mirror") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    for (const bool emission : {true, false}) {
      for (const float albedo : {0.0f, 1.0f}) {
        INFO("emission image: " << emission << ", albedo around the lamp: " << albedo);
        DemodulateCase demodulate(options, {{emission, true}});
        for (float& value : demodulate.inputs.material.albedo.pixels) value = albedo;
        for (float& value : demodulate.inputs.material.emission.pixels) value = 0.0f;
        demodulate.uploadAndRun();
        const Planes without = weightsOf(demodulate);
        addLamp(demodulate.inputs.material);
        checkAgreement(demodulate, options);
        const Planes with = weightsOf(demodulate);
        forEachPixel(options.size, [&](int x, int y) {
          CHECK(with.at(0, x, y) == (isInLamp(x, y) ? 0.0f : without.at(0, x, y)));
        });
      }
    }
  }
}

TEST_CASE("demodulate leaves out a lobe that is not there, but not one without a colour") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    DemodulateCase demodulate(options, kEverything);
    MaterialImages& material = demodulate.inputs.material;
    for (float& value : material.glossColor.pixels) value = 1.0f;
    demodulate.uploadAndRun();
    const Planes first = weightsOf(demodulate), all = weightsOf(demodulate, 1);
    const auto isDark = [](int x, int y) { return (x / 3 + y) % 2 == 0; };
    forEachPixel(options.size, [&](int x, int y) {
      for (int c = 0; c < 3; ++c) {
        material.glossColor.at(x, y, c) = 0.0f;
        if (isDark(x, y)) material.glossyRadiance.at(x, y, c) = 0.0f;
      }
    });
    checkAgreement(demodulate, options);
    const Planes lit = weightsOf(demodulate, 1), irradiance = demodulate.irradiance();
    CHECK(sameBits(weightsOf(demodulate), first));
    forEachPixel(options.size, [&](int x, int y) {
      CHECK(lit.at(0, x, y) == (isDark(x, y) ? 0.0f : all.at(0, x, y)));
      if (lit.at(0, x, y) == 0.0f) return;
      for (int c = 0; c < 3; ++c) CHECK(irradiance.at(3 + c, x, y) == material.glossyRadiance.at(x, y, c));
    });
  }
}
