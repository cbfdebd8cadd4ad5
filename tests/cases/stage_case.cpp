#include "tests/cases/stage_case.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/core/frame_images.hpp"
#include "kernels/accumulate_noisy_params.h"

namespace quell::tests {
namespace {

int powerOfMoment(int plane) { return plane % QUELL_MOMENT_PLANES == QUELL_MOMENT_FIRST ? 1 : 2; }

}  // namespace

Comparison StageCase::check() {
  uploadAndRun();
  Comparison comparison = compare();
  m_holes.compare(comparison, m_harness, m_reprojection.viewDepth.w);
  return comparison;
}

LightInput lightOf(Planes& planes, int power) { return {planes.values.data(), planes.values.size(), power}; }
LightInput lightOf(io::Image& image) { return {image.pixels.data(), image.pixels.size()}; }

std::vector<LightInput> momentsOf(Planes& moments) {
  std::vector<LightInput> inputs;
  const std::size_t pixels = moments.index(1, 0, 0);
  for (int plane = 0; plane < moments.count; ++plane)
    inputs.push_back({moments.values.data() + moments.index(plane, 0, 0), pixels, powerOfMoment(plane)});
  return inputs;
}

Comparison StageCase::checkInLight(double factor) {
  std::vector<std::vector<float>> kept;
  for (const LightInput& input : light()) {
    kept.emplace_back(input.values, input.values + input.count);
    std::transform(input.values, input.values + input.count, input.values,
                   [&](float value) { return float(value * std::pow(factor, input.power)); });
  }
  m_lightUnit = factor;
  const Comparison comparison = check();
  m_lightUnit = 1.0;
  const std::vector<LightInput> inputs = light();  // upload() may have moved them
  for (std::size_t i = 0; i < inputs.size(); ++i)
    std::copy_n(kept[i].begin(), inputs[i].count, inputs[i].values);
  uploadAndRun();
  return comparison;
}

void StageCase::compareMoments(Comparison& comparison, const Planes& device, const ExactPlanes& exact,
                               const BasicPlanes<char>* excluded, const ExactPlanes* scales) const {
  for (int plane = 0; plane < exact.count; ++plane) {
    const ExactPlanes planeScales = scales ? planesOf(*scales, plane, 1) : ExactPlanes();
    comparePixels(comparison, "moment " + std::to_string(plane), planesOf(device, plane, 1),
                  planesOf(exact, plane, 1), excluded, scales ? &planeScales : nullptr,
                  std::pow(m_lightUnit, powerOfMoment(plane)));
  }
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
  setup.skip = options.holes();
  if (options.skip == Skip::OnJittered) setup.frame.camera.jitterPx = {0.25, -0.125};
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
                   const ExactPlanes& exact, const BasicPlanes<char>* excluded, const ExactPlanes* scales,
                   double unit) {
  const io::Image pixels = harness.output(image);
  if (pixels.channels == 4)
    forEachPixel(exact.size(),
                 [&](int x, int y) { comparison.include("alpha", 3, x, y, pixels.at(x, y, 3), 1.0); });
  comparePixels(comparison, "output", outputPlanes(harness, image), exact, excluded, scales, unit);
  const ImageView& view = harness.configuration().output.*image;
  if (!gapsUntouched(harness.outputBytes(image), view, exact.size()))
    comparison.include("bytes between pixels", 0, -1, -1, std::numeric_limits<double>::infinity(), 0.0);
}

void uploadTapWeights(StageHarness& harness, const Planes& guides) {
  const int signals = signalCount(harness.configuration().frame);
  if (harness.hasPort("tapWeights"))
    harness.upload("tapWeights", planesOf(guides, QUELL_GUIDE_WEIGHT, signals));
}

}  // namespace quell::tests
