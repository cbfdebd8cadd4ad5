#include "tests/cases/filter_inputs.hpp"

#include <Eigen/Core>

#include "kernels/common/guides.h"
#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

constexpr double kTilt = 6.0;             // of the scene, units of depth over the width of the image
constexpr double kDepthRoughness = 0.02;  // scene units
constexpr double kNormalRoughness = 0.1;

void roughenNormal(Planes& guides, int x, int y, Random& random) {
  Eigen::Vector3d normal;
  for (int axis = 0; axis < 3; ++axis)
    normal[axis] = guides.at(QUELL_GUIDE_NORMAL + axis, x, y) + kNormalRoughness * random.uniform(-1.0, 1.0);
  normal.normalize();
  for (int axis = 0; axis < 3; ++axis) guides.at(QUELL_GUIDE_NORMAL + axis, x, y) = float(normal[axis]);
}

float randomWeight(Random& random) {
  const double kind = random.uniform();
  return kind < 0.05 ? 0.0f : kind < 0.2 ? float(random.uniform(0.001, 1.0)) : 1.0f;
}

}  // namespace

void setFilterMethod(StageSetup& setup, const std::string& method, const FilterVariant& variant) {
  setup.frame.radiance = makeView(packed(3), setup.size);
  if (variant.signals == 2) setup.frame.glossyRadiance = makeView(packed(3), setup.size);
  if (variant.roughness) setup.frame.roughness = makeView(packed(1), setup.size);
  setup.settings = Settings(method);
  setup.settings.set("depthSigma", 1.5);
  setup.settings.set("normalPower", 100.0);
  setup.settings.set("luminanceSigma", 3.0);
  if (variant.roughness) setup.settings.set("roughnessSigma", 0.5);
}

EdgeStopParams edgeStopsOf(const Settings& settings) {
  const double roughnessSigma = settings.get("roughnessSigma");
  EdgeStopParams stops{};
  stops.normalPower = float(settings.get("normalPower"));
  stops.inverseDepth = float(1.0 / settings.get("depthSigma"));
  stops.inverseRoughness = roughnessSigma > 0.0 ? float(1.0 / roughnessSigma) : 0.0f;
  return stops;
}

FilterGuides randomGuides(const FilterVariant& variant, const CaseOptions& options) {
  const Size size = options.size;
  Random random(options.seed);
  const SceneView view = renderScene({}, size, variant.signals, options.holes());
  FilterGuides guides{view.guides, Planes(size, 1), {}};
  forEachPixel(size, [&](int x, int y) {
    if (view.viewDepth.at(x, y, 0) == 0.0f) return;  // sky
    guides.viewDepth.at(0, x, y) =
        float(view.viewDepth.at(x, y, 0) + kTilt * x / size.width + kDepthRoughness * random.uniform());
    roughenNormal(guides.guides, x, y, random);
    for (int signal = 0; signal < variant.signals; ++signal)
      guides.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y) = randomWeight(random);
  });
  if (variant.roughness) guides.roughness = randomPlanes(size, 1, options.seed + 1);
  return guides;
}

void uploadGuides(StageHarness& harness, const FilterGuides& guides) {
  harness.upload("guides", guides.guides);
  harness.upload("viewDepth", guides.viewDepth);
  if (guides.roughness.count > 0) harness.upload("roughness", guides.roughness);
}

}  // namespace quell::tests
