#include "tests/cases/feature_inputs.hpp"

#include "tests/support/random_images.hpp"

namespace quell::tests {

Planes withMaterials(const Planes& guides, unsigned seed) {
  Planes all = guides;
  const Planes materials = randomPlanes(guides.size(), QUELL_MATERIAL_PLANES, seed, 0.0, 1.0);
  all.count = kGuideAndMaterialPlanes;
  all.values.insert(all.values.end(), materials.values.begin(), materials.values.end());
  return all;
}

Planes randomRecords(const FeatureNames& list, int count, unsigned seed) {
  Random random(seed);
  std::vector<FitRecord> records(static_cast<std::size_t>(count), FitRecord(list));
  for (FitRecord& record : records) {
    record.coefficients = record.coefficients.unaryExpr([&](double) { return random.uniform(-1.0, 2.0); });
    for (double& anchor : record.anchor) anchor = random.uniform(-8.0, 2.0);
    for (double& scale : record.scale) scale = random.uniform(0.1, 2.0);
  }
  return packRecords(records);
}

QuellFloat4 viewAxisOf(const FeatureNames& list) {
  return {float(list.viewAxis[0]), float(list.viewAxis[1]), float(list.viewAxis[2]), 0.0f};
}

}  // namespace quell::tests
