#include "tests/cases/stage_case.hpp"

#include <limits>

namespace quell::tests {

Comparison StageCase::check() {
  upload();
  run();
  return compare();
}

double StageCase::bytesPerPixel() const {
  return double(bytesMoved()) / (double(size().width) * double(size().height));
}

double storageError(const ImageLayout& layout) {
  return layout.format == ComponentFormat::Float16 ? kHalfRounding : 0.0;
}

StageSetup makeSetup(const CaseOptions& options) {
  StageSetup setup;
  setup.size = options.size;
  setup.mapping = options.mapping;
  setup.workGroup = options.workGroup;
  setup.fitGroup = options.fitGroup;
  setup.settings.set("features", options.features);
  const FitFeatures features(options.features);
  if (features.needAlbedo()) setup.frame.albedo = packedImage(nullptr, 3);
  if (features.needRoughness()) setup.frame.roughness = packedImage(nullptr, 1);
  return setup;
}

Planes outputPlanes(const StageHarness& harness, ImageView Output::*image) {
  const io::Image pixels = harness.output(image);
  Planes planes(harness.size(), 3);
  forEachPixel(harness.size(), [&](int x, int y) {
    for (int c = 0; c < 3; ++c) planes.at(c, x, y) = pixels.at(x, y, c);
  });
  return planes;
}

void compareOutput(Comparison& comparison, const StageHarness& harness, ImageView Output::*image,
                   const ExactPlanes& exact, const BasicPlanes<char>* excluded, const ExactPlanes* scales) {
  const io::Image pixels = harness.output(image);
  if (pixels.channels == 4)
    forEachPixel(exact.size(),
                 [&](int x, int y) { comparison.include("alpha", 3, x, y, pixels.at(x, y, 3), 1.0); });
  comparePixels(comparison, "output", outputPlanes(harness, image), exact, excluded, scales);
  const ImageView& view = harness.configuration().output.*image;
  if (!gapsUntouched(harness.outputBytes(image), view, exact.size()))
    comparison.include("bytes between pixels", 0, 0, 0, std::numeric_limits<double>::infinity(), 0.0);
}

}  // namespace quell::tests
