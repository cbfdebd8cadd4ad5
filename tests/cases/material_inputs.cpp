#include "tests/cases/material_inputs.hpp"

#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr double kBrightest = 8.0;       // radiance
constexpr double kFadingFactor = 0.012;  // just above the factor below which a channel is weak

// In a quarter of the pixels most channels are black or nearly so.
io::Image randomFactor(Size size, unsigned seed, double largest) {
  Random random(seed);
  io::Image image(size.width, size.height, 3);
  forEachPixel(size, [&](int x, int y) {
    const bool fades = random.uniform() < 0.25;
    for (int c = 0; c < 3; ++c) {
      const double kind = fades ? random.uniform() : 1.0;
      image.at(x, y, c) =
          kind < 0.2 ? 0.0f : float(random.uniform(0.0, kind < 0.8 ? kFadingFactor : largest));
    }
  });
  return image;
}

}  // namespace

void uploadImage(StageHarness& harness, ImageView Frame::*view, io::Image& image) {
  if (image.empty()) return;
  harness.setInput(view, image);
  image = asStored(image, harness.configuration().frame.*view);
}

void setMaterialViews(StageSetup& setup, const MaterialVariant& variant, const ImageLayout& layout) {
  const ImageView view = makeView(layout, setup.size);
  Frame& frame = setup.frame;
  frame.radiance = view;
  if (variant.twoSignals) frame.glossyRadiance = view;
  if (variant.emission) frame.emission = view;
  if (variant.albedo) frame.albedo = view;
  if (variant.glossColor) frame.glossColor = view;
  frame.demodulated = variant.demodulated;
  setup.settings.set("demodulate", variant.fBeta ? "fbeta" : variant.divide ? "albedo" : "none");
  if (variant.fBeta || variant.f0) frame.f0 = view;
}

MaterialImages randomMaterial(const MaterialVariant& variant, Size size, unsigned seed) {
  MaterialImages images;
  images.radiance = randomImage(size, 3, seed, 0.0, kBrightest);
  if (variant.emission) images.emission = randomImage(size, 3, seed + 1, 0.0, 0.5);
  if (variant.albedo) images.albedo = randomFactor(size, seed + 2, 1.0);
  if (variant.glossColor) images.glossColor = randomFactor(size, seed + 3, 0.3);
  if (variant.twoSignals) images.glossyRadiance = randomImage(size, 3, seed + 4, 0.0, kBrightest);
  if (variant.fBeta || variant.f0) images.f0 = randomImage(size, 3, seed + 5, -0.1, 1.1);
  images.demodulated = variant.demodulated;
  images.divide = variant.divide;
  return images;
}

std::vector<LightInput> lightOf(MaterialImages& images) {
  return {lightOf(images.radiance), lightOf(images.emission), lightOf(images.glossyRadiance)};
}

void uploadMaterial(StageHarness& harness, MaterialImages& images) {
  uploadImage(harness, &Frame::radiance, images.radiance);
  uploadImage(harness, &Frame::glossyRadiance, images.glossyRadiance);
  uploadImage(harness, &Frame::emission, images.emission);
  uploadImage(harness, &Frame::albedo, images.albedo);
  uploadImage(harness, &Frame::glossColor, images.glossColor);
  uploadImage(harness, &Frame::f0, images.f0);
}

}  // namespace quell::tests
