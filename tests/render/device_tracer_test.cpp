// Tracing on a queue of the caller's: the images stay on the device and are those that PathTracer reads back.
#include "host/render/device_tracer.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <quell/devices.hpp>
#include <vector>

#include "host/render/scene_registry.hpp"
#include "tests/render/render_support.hpp"

namespace quell::tests {
namespace {

constexpr Size kSize{40, 23};
constexpr int kSamples = 11;  // more than one launch, and not a multiple of it

struct Traced {
  Traced() {
    const render::SceneEntry& scene = render::findScene("roughness");
    tracer.traceFeatures(render::makeScene(scene, 1), render::makeScene(scene, 0));
    tracer.traceLight(render::mixSeed(1, 1, render::kNoisyStream), kSamples);
    queue.finish();
  }

  io::Image read(const cl::Buffer& buffer) {
    io::Image image(kSize.width, kSize.height, 3);
    queue.enqueueReadBuffer(buffer, CL_TRUE, 0, image.pixels.size() * sizeof(float), image.pixels.data());
    return image;
  }

  cl::Device device{chooseDevice(testDevice()).device, true};
  cl::Context context{device};
  cl::CommandQueue queue{context, device, CL_QUEUE_PROFILING_ENABLE};
  render::DeviceTracer tracer{context, device, queue, defaultCacheDirectory(), kSize, true};
};

}  // namespace

TEST_CASE("images on the device are those in host memory, and the picture is composed of them", "[render]") {
  Traced traced;
  render::PathTracer reader = makeTracer(kSize);
  const render::SceneEntry& scene = render::findScene("roughness");
  const render::Features features = reader.features(render::makeScene(scene, 1), render::makeScene(scene, 0));
  const render::Light light = reader.light(render::mixSeed(1, 1, render::kNoisyStream), kSamples);
  const render::TracedImages& images = traced.tracer.images();
  CHECK(traced.read(images.positionWorld).pixels == features.positionWorld.pixels);
  CHECK(traced.read(images.diffuse).pixels == light.diffuse.pixels);
  CHECK(traced.read(images.glossyRadiance).pixels == light.glossy.pixels);

  const io::Image color = traced.read(images.radiance), expected = render::composeColor(features, light);
  double sum = 0.0;
  for (std::size_t i = 0; i < color.pixels.size(); ++i) {
    // A few roundings to single precision, in another order.
    CHECK(std::abs(color.pixels[i] - expected.pixels[i]) <= 1e-6f * (1.0f + expected.pixels[i]));
    sum += color.pixels[i];
  }
  CHECK(sum > 0.0);
}

TEST_CASE("the tracer times its kernels, frame by frame", "[render]") {
  Traced traced;
  const Timings timings = traced.tracer.timings();
  CHECK(timings.frame.count == 1);
  REQUIRE(timings.stages.size() == 3);
  CHECK(timings.stages[0].stage == "primary");
  CHECK(timings.stages[1].stage == "shade");
  CHECK(timings.stages[2].stage == "compose");
  for (const StageTimings& stage : timings.stages) CHECK(stage.time.medianMs > 0.0);
}

}  // namespace quell::tests
