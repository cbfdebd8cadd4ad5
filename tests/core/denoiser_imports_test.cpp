// Inputs that hold something else than stages read: sums, other kinds of depth, other units of motion, rows bottom-up.
#include <catch2/catch.hpp>
#include <functional>

#include "host/core/view_rays.hpp"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kLastFrame = 2;

struct Twist {
  std::function<void(Frame&)> layout;                                     // once
  std::function<void(Frame&, const ImageView&, io::Image&)> values = {};  // of every image, every frame
};

// The method with the fewest kernels to compile.
Settings quickSettings() {
  Settings settings("atrous");
  settings.set("iterations", 1.0);
  return settings;
}

// Denoises the first frames of the built-in sequence with images that a renderer would hand over in its own way.
Picture denoised(const ImageSetup& setup, const Twist& twist, const Settings& settings = quickSettings()) {
  const OpenDevice device;
  FrameBuffers buffers(device, setup);
  Denoiser denoiser(device.context, device.device, device.queue, settings, testOptions());
  Frame frame = buffers.frame;
  twist.layout(frame);
  denoiser.prepare(frame, buffers.output);
  for (int number = 0; number <= kLastFrame; ++number) {
    buffers.upload(number);
    frame.camera = buffers.frame.camera;
    for (const auto& image : kInputs<Frame>) {
      const ImageView &plain = buffers.frame.*image.member, &view = frame.*image.member;
      if (!view.present()) continue;
      io::Image values = decodeImage(buffers.bytes(plain), plain, frame.size);
      if (image.member == &Frame::motion)  // the sequence has none of its own
        for (std::size_t i = 0; i < values.pixels.size(); ++i) values.pixels[i] = float(i % 5) * 0.25f - 0.5f;
      if (twist.values) twist.values(frame, view, values);
      const auto bytes = encodeImage(values, view, frame.size);
      device.queue.enqueueWriteBuffer(cl::Buffer(view.memory, true), CL_TRUE, 0, bytes.size(), bytes.data());
    }
    denoiser.denoise(frame, buffers.output).wait();
  }
  return buffers.download();
}

const Twist kPlain = {[](Frame&) {}};

double largestDifference(const Picture& a, const Picture& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.display.pixels.size(); ++i)
    largest = std::max(largest, double(std::abs(a.display.pixels[i] - b.display.pixels[i])));
  return largest;
}

ImageSetup withDepth() {
  ImageSetup setup;
  setup.positionWorld = absent();
  setup.viewDepth = packed(1);
  return setup;
}

// Powers of two, so that nothing is rounded.
float countAt(std::size_t pixel) { return float(1 << pixel % 4); }

}  // namespace

TEST_CASE("sums with their count in the fourth component are means", "[core]") {
  ImageSetup setup;
  setup.radiance = setup.normalWorld = setup.positionWorld = setup.albedo = packed(4);
  const Twist sums = {
      [](Frame& frame) {
        for (ImageView* view : {&frame.radiance, &frame.normalWorld, &frame.positionWorld, &frame.albedo})
          *view = summed(*view);
      },
      [](Frame&, const ImageView& view, io::Image& values) {
        if (view.sum == Sum::None) return;
        for (std::size_t i = 0; i < values.pixels.size(); ++i)
          values.pixels[i] = i % 4 == 3 ? countAt(i / 4) : values.pixels[i] * countAt(i / 4);
      }};
  CHECK(denoised(setup, sums) == denoised(setup, kPlain));
}

TEST_CASE("sums over one number of samples are means", "[core]") {
  const Twist sums = {[](Frame& frame) {
                        frame.sampleCount = 8.0;
                        frame.radiance = summed(frame.radiance, Sum::OverSampleCount);
                        frame.albedo = summed(frame.albedo, Sum::OverSampleCount);
                      },
                      [](Frame&, const ImageView& view, io::Image& values) {
                        for (float& value : values.pixels) value *= view.sum == Sum::None ? 1.0f : 8.0f;
                      }};
  CHECK(denoised({}, sums) == denoised({}, kPlain));
}

TEST_CASE("a sum of no samples is a missing sample", "[core]") {
  ImageSetup setup;
  setup.radiance = packed(4);
  const Twist none = {[](Frame& frame) { frame.radiance = summed(frame.radiance); },
                      [](Frame&, const ImageView& view, io::Image& values) {
                        if (view.sum == Sum::None) return;
                        for (std::size_t i = 0; i < values.pixels.size(); ++i)
                          values.pixels[i] = i / 4 % 3 == 0 ? 0.0f : i % 4 == 3 ? 1.0f : values.pixels[i];
                      }};
  for (const float value : denoised(setup, none).linear.pixels) CHECK(std::isfinite(value));
}

TEST_CASE("depth of every kind gives the picture of view depth", "[core]") {
  const Picture expected = denoised(withDepth(), kPlain);
  const auto kind = [](DepthKind depthKind, const std::function<double(double)>& fromView) {
    return Twist{[depthKind](Frame& frame) {
                   frame.depthKind = depthKind;
                   frame.depthNear = 0.125;
                   frame.depthFar = 64.0;
                 },
                 [fromView](Frame& frame, const ImageView& view, io::Image& values) {
                   if (&view != &frame.viewDepth) return;
                   for (float& value : values.pixels) value = float(fromView(double(value)));
                 }};
  };
  CHECK(denoised(withDepth(), kind(DepthKind::NegativeView, [](double z) { return -z; })) == expected);
  const auto reversed = [](double z) { return (1.0 / z - 1.0 / 64.0) / (8.0 - 1.0 / 64.0); };
  CHECK(largestDifference(denoised(withDepth(), kind(DepthKind::Reversed, reversed)), expected) < 1e-2);
  const auto hyperbolic = [reversed](double z) { return 1.0 - reversed(z); };
  CHECK(largestDifference(denoised(withDepth(), kind(DepthKind::Hyperbolic, hyperbolic)), expected) < 5e-2);
}

TEST_CASE("distances along rays give the picture of view depth", "[core]") {
  const Twist alongRays = {[](Frame& frame) { frame.depthKind = DepthKind::Ray; },
                           [](Frame& frame, const ImageView& view, io::Image& values) {
                             if (&view != &frame.viewDepth) return;
                             const Matrix4& m = frame.camera.worldToClip;
                             const ViewRays rays = viewRays(m, frame.camera.jitterPx, frame.size);
                             for (int y = 0; y < values.height; ++y)
                               for (int x = 0; x < values.width; ++x) {
                                 const auto ray = rays.at(x, y);
                                 values.at(x, y, 0) *= float(std::hypot(ray[0], ray[1], ray[2]));
                               }
                           }};
  CHECK(largestDifference(denoised(withDepth(), alongRays), denoised(withDepth(), kPlain)) < 1e-2);
}

TEST_CASE("motion of another unit and sign is scaled", "[core]") {
  ImageSetup setup;
  setup.motion = packed(2);
  const Twist scaled = {[](Frame& frame) {
                          frame.motionScale = {4.0, -0.5};
                        },
                        [](Frame& frame, const ImageView& view, io::Image& values) {
                          if (&view != &frame.motion) return;
                          for (std::size_t i = 0; i < values.pixels.size(); ++i)
                            values.pixels[i] *= i % 2 == 0 ? 0.25f : -2.0f;
                        }};
  const Picture expected = denoised(setup, kPlain, Settings());
  CHECK(denoised(setup, scaled, Settings()) == expected);
  const Twist other = {[](Frame& frame) { frame.motionScale = {-1.0, 1.0}; }};
  CHECK_FALSE(denoised(setup, other, Settings()) == expected);
}

TEST_CASE("rows may lie bottom-up", "[core]") {
  const Picture expected = denoised({}, kPlain);
  const Twist turned = {[](Frame& frame) {
    for (ImageView* view : {&frame.radiance, &frame.normalWorld, &frame.positionWorld, &frame.albedo})
      *view = bottomUp(*view, frame.size);
  }};
  CHECK(denoised({}, turned) == expected);
  SmallDenoiser small({}, testOptions(), 0, quickSettings());
  Output output = small.buffers.output;
  output.linear = bottomUp(output.linear, small.buffers.frame.size);
  small.denoiser.prepare(small.buffers.frame, output);
  for (int number = 0; number <= kLastFrame; ++number) {
    small.buffers.upload(number);
    small.denoiser.denoise(small.buffers.frame, output).wait();
  }
  CHECK(decodeImage(small.buffers.bytes(output.linear), output.linear, small.buffers.frame.size).pixels ==
        expected.linear.pixels);
}

TEST_CASE("the denoiser remembers the camera of the frame before", "[core]") {
  SmallDenoiser given, remembered;
  for (int number = 0; number <= kLastFrame; ++number) {
    const Picture expected = given.run(number);
    remembered.buffers.upload(number);
    remembered.buffers.frame.camera.worldToClipPrev = {};
    remembered.enqueue().wait();
    CHECK(remembered.buffers.download() == expected);
  }
}

TEST_CASE("numbers that say nothing are refused", "[core]") {
  SmallDenoiser small(withDepth(), testOptions(), 0, quickSettings());
  Frame& frame = small.buffers.frame;
  const auto refused = [&](const char* name, const char* expected) {
    checkRefused({ErrorCode::InvalidArgument, "denoise", name, expected, ""}, [&] { small.enqueue(); });
  };
  frame.motionScale = {0.0, 1.0};
  refused("motionScale", "other than 0");
  frame.motionScale = {1.0, 1.0};
  frame.sampleCount = 0.0;
  refused("sampleCount", "above 0");
  frame.sampleCount = 1.0;
  frame.depthKind = DepthKind::Hyperbolic;
  checkRefused({ErrorCode::NotPrepared, "denoise", "depthKind", "View, as prepared", "Hyperbolic"},
               [&] { small.enqueue(); });
  small.denoiser.prepare(frame, small.buffers.output);
  refused("depthNear", "near plane");
  frame.depthNear = 1.0;
  refused("depthFar", "finite");
}

TEST_CASE("sums are refused where they have no count or no meaning", "[core]") {
  SmallDenoiser small;
  Frame frame = small.buffers.frame;
  Output output = small.buffers.output;
  frame.radiance = summed(frame.radiance);
  checkRefused({ErrorCode::InvalidArgument, "prepare", "radiance", "4 channels", "3"},
               [&] { small.denoiser.prepare(frame, output); });
  output.linear = summed(output.linear, Sum::OverSampleCount);
  checkRefused({ErrorCode::InvalidArgument, "prepare", "output.linear", "values", "sums"},
               [&] { small.denoiser.prepare(small.buffers.frame, output); });
}

}  // namespace quell::tests
