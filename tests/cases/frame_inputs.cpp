#include "tests/cases/frame_inputs.hpp"

#include <algorithm>

#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {

void setFrameViews(StageSetup& setup, const FrameVariant& variant, const ImageLayout& layout) {
  setMaterialViews(setup, variant.material, layout);
  ImageLayout guide = layout;
  guide.channels = std::max(3, guide.channels);
  setup.frame.normalWorld = makeView(guide, setup.size);
  guide.format = ComponentFormat::Float32;
  if (!variant.viewDepth) setup.frame.positionWorld = makeView(guide, setup.size);
  guide.channels = 1;
  if (variant.viewDepth) setup.frame.viewDepth = makeView(guide, setup.size);
  if (variant.roughness) setup.frame.roughness = makeView(guide, setup.size);
}

FrameImages randomFrame(const FrameVariant& variant, const CaseOptions& options) {
  const SceneView view = renderScene({}, options.size, 1, options.holes());
  FrameImages frame;
  frame.material = randomMaterial(variant.material, options.size, options.seed);
  frame.normal = view.normalWorld;
  frame.position = variant.viewDepth ? view.viewDepth : view.positionWorld;
  frame.positionIsDepth = variant.viewDepth;
  if (variant.roughness) frame.roughness = randomImage(options.size, 1, options.seed + 10, -0.1, 1.1);
  return frame;
}

void uploadFrame(StageHarness& harness, FrameImages& frame) {
  uploadMaterial(harness, frame.material);
  harness.setInput(&Frame::normalWorld, frame.normal);
  harness.setInput(frame.positionIsDepth ? &Frame::viewDepth : &Frame::positionWorld, frame.position);
  frame.normal = asStored(frame.normal, harness.configuration().frame.normalWorld);
  if (!frame.roughness.empty()) harness.setInput(&Frame::roughness, frame.roughness);
}

}  // namespace quell::tests
