// The scene moving-objects denoised: what moves is as good as the same pose at rest, so neither ghosts nor lost history.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <vector>

#include "host/cli/common/denoise_session.hpp"
#include "host/metrics/display_encoding.hpp"
#include "host/render/pinhole_camera.hpp"
#include "host/render/scene_registry.hpp"
#include "tests/render/render_support.hpp"

namespace quell::tests {
namespace {

constexpr Size kSize{160, 90};
constexpr int kFrames = 12;            // more than the 1 / 0.1 that the longest history averages
constexpr int kReferenceSamples = 96;  // of each half
constexpr double kMovedPx = 0.25;      // beside the camera's own motion
constexpr double kSlowTurnDeg = 2.0;   // in a frame

// The rendered scene, and how it got to where it is in the last frame.
struct Sequence {
  std::vector<io::FrameData> frames;
  io::Image referenceA, referenceB;  // of the last frame, display-encoded
  std::vector<char> moved;           // pixels of the last frame, see movedPixels()
  std::vector<char> slow;            // those of them that turn slowly
};

io::FrameData frameOf(const render::Features& f, const render::Light& light, const render::Scene& now,
                      const render::Scene& before, int number) {
  io::FrameData frame = f;
  frame.number = number;
  frame.camera.worldToClip = render::worldToClip(now.camera, kSize.width, kSize.height);
  frame.camera.worldToClipPrev = render::worldToClip(before.camera, kSize.width, kSize.height);
  frame.radiance = render::composeColor(f, light);
  return frame;
}

// Frames in which each pixel's surface point has been visible so far, this one included.
std::vector<int> agesAfter(const std::vector<int>& before, const io::FrameData& frame,
                           const io::Image& objectIdBefore) {
  std::vector<int> ages;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const int xPrev = int(std::lround(x + double(frame.motion.at(x, y, 0))));
      const int yPrev = int(std::lround(y + double(frame.motion.at(x, y, 1))));
      const bool seen = !before.empty() && xPrev >= 0 && yPrev >= 0 && xPrev < kSize.width &&
                        yPrev < kSize.height &&
                        objectIdBefore.at(xPrev, yPrev, 0) == frame.objectId.at(x, y, 0);
      ages.push_back(seen ? before[std::size_t(yPrev * kSize.width + xPrev)] + 1 : 1);
    }
  }
  return ages;
}

// How far each pixel's surface has turned since the frame before, degrees.
double turnOf(const io::FrameData& frame, const io::FrameData& before, int x, int y) {
  const int xPrev = int(std::lround(x + double(frame.motion.at(x, y, 0))));
  const int yPrev = int(std::lround(y + double(frame.motion.at(x, y, 1))));
  const double cosine = glm::dot(pixel3(frame.normalWorld, x, y), pixel3(before.normalWorld, xPrev, yPrev));
  return glm::degrees(std::acos(std::min(1.0, cosine)));
}

// Pixels whose surface moves other than by the camera, and was visible in all frames: as long a history as at rest.
std::vector<char> movedPixels(render::PathTracer& tracer, const render::Scene& now,
                              const render::Scene& before, const std::vector<int>& ages) {
  render::Scene still = now;
  still.camera = before.camera;
  const io::Image all = tracer.features(now, before).motion, ofCamera = tracer.features(now, still).motion;
  std::vector<char> moved;
  for (std::size_t i = 0; i < ages.size(); ++i) {
    const double x = double(all.pixels[2 * i]) - ofCamera.pixels[2 * i];
    const double y = double(all.pixels[2 * i + 1]) - ofCamera.pixels[2 * i + 1];
    moved.push_back(ages[i] == kFrames && std::hypot(x, y) > kMovedPx);
  }
  return moved;
}

Sequence renderFrames(const std::function<render::Scene(int)>& sceneAt) {
  render::PathTracer tracer = makeTracer(kSize);
  Sequence sequence;
  std::vector<int> ages;
  for (int number = 0; number < kFrames; ++number) {
    const render::Scene now = sceneAt(number), before = sceneAt(number - 1);
    const render::Features features = tracer.features(now, before);
    const render::Light light = tracer.light(render::mixSeed(1, number, 0), 1);
    sequence.frames.push_back(frameOf(features, light, now, before, number));
    const io::FrameData& last = sequence.frames.back();
    ages =
        agesAfter(ages, last, number > 0 ? sequence.frames[std::size_t(number) - 1].objectId : io::Image());
    if (number + 1 < kFrames) continue;
    const auto reference = [&](int half) {
      return metrics::encodeForDisplay(
          composeColor(features, tracer.light(render::mixSeed(1, number, half), kReferenceSamples)));
    };
    sequence.referenceA = reference(1);
    sequence.referenceB = reference(2);
    sequence.moved = movedPixels(tracer, now, before, ages);
    sequence.slow = sequence.moved;
    for (int y = 0; y < kSize.height; ++y)
      for (int x = 0; x < kSize.width; ++x) {
        char& slow = sequence.slow[std::size_t(y * kSize.width + x)];
        slow = slow && turnOf(last, sequence.frames[std::size_t(number) - 1], x, y) < kSlowTurnDeg;
      }
  }
  return sequence;
}

// Unbiased RMSE of the last frame over these pixels, before TAA.
double errorOver(const std::vector<char>& pixels, const Sequence& sequence, const std::string& method,
                 cli::MotionUse motion) {
  cli::DenoiseSession session(testDevice(), Settings(method), Options(), sequence.frames.front(), motion);
  io::Image last;
  for (const io::FrameData& frame : sequence.frames) last = session.denoise(frame).linear;
  const io::Image encoded = metrics::encodeForDisplay(last);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < encoded.pixels.size(); ++i) {
    if (!pixels[i / 3]) continue;
    sum += (double(encoded.pixels[i]) - sequence.referenceA.pixels[i]) *
           (double(encoded.pixels[i]) - sequence.referenceB.pixels[i]);
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

}  // namespace

TEST_CASE("with motion vectors moving objects are denoised as well as at rest", "[render]") {
  const render::SceneEntry& entry = render::findScene("moving-objects");
  const Sequence moving = renderFrames([&](int frame) { return render::makeScene(entry, frame); });
  const Sequence atRest = renderFrames([&](int) { return render::makeScene(entry, kFrames - 1); });
  REQUIRE(std::count(moving.moved.begin(), moving.moved.end(), char(1)) > 500);
  REQUIRE(std::count(moving.slow.begin(), moving.slow.end(), char(1)) > 40);
  for (const std::string method : {"bmfr", "svgf"}) {
    const auto check = [&](const std::vector<char>& pixels, double most) {
      const double rest = errorOver(pixels, atRest, method, cli::MotionUse::WherePresent);
      const double followed = errorOver(pixels, moving, method, cli::MotionUse::WherePresent);
      const double discarded = errorOver(pixels, moving, method, cli::MotionUse::Never);
      INFO(method << ": at rest " << rest << ", with motion vectors " << followed << ", without "
                  << discarded);
      CHECK(followed < most * rest);
      CHECK(followed < discarded);
    };
    // Some fifty pixels, most of them at silhouettes, whose gloss no feature of bmfr tells.
    if (method != "bmfr") check(moving.slow, 1.25);
    // What turns fast has a short history, since its light does not turn with it: less for svgf to average.
    check(moving.moved, method == "bmfr" ? 1.25 : 1.4);
  }
  // At rest the long history of quell gives errors that it cannot have in motion; there it is compared with svgf.
  const auto check = [&](const std::vector<char>& pixels, double most) {
    const auto error = [&](const std::string& method, cli::MotionUse motion) {
      return errorOver(pixels, moving, method, motion);
    };
    const double followed = error("quell", cli::MotionUse::WherePresent);
    const double ofSvgf = error("svgf", cli::MotionUse::WherePresent);
    INFO("quell " << followed << ", svgf " << ofSvgf);
    CHECK(followed < most * ofSvgf);
    CHECK(followed < error("quell", cli::MotionUse::Never));
  };
  check(moving.slow, 1.25);  // some fifty pixels, most of them at silhouettes
  check(moving.moved, 1.05);
}

}  // namespace quell::tests
