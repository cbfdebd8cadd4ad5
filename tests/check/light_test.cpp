// Light, its noise and its references.
#include <catch2/catch.hpp>
#include <limits>
#include <memory>

#include "host/analytic/sequence.hpp"
#include "host/check/noise.hpp"
#include "host/check/reference_checks.hpp"
#include "tests/check/plane_frames.hpp"
#include "tests/support/check_kinds.hpp"
#include "tests/support/tool.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

std::unique_ptr<io::FrameSequence> room(bool movingCamera) {
  io::AnalyticOptions options;
  options.width = 160;
  options.height = 90;
  options.movingCamera = movingCamera;
  return io::makeAnalyticSequence(options);
}

io::FrameData numbered(io::FrameData frame, int number) {
  frame.number = number;
  return frame;
}

// Without noise: light that changes smoothly over the picture.
io::FrameData withoutNoise(io::FrameData frame) {
  for (int y = 0; y < frame.radiance.height; ++y)
    for (int x = 0; x < frame.radiance.width; ++x)
      for (int c = 0; c < 3; ++c)
        frame.radiance.at(x, y, c) =
            frame.emission.at(x, y, c) + frame.albedo.at(x, y, c) * float(1 + 0.01 * x);
  return frame;
}

bool isFrozen(const io::FrameData& before, const io::FrameData& now) {
  return kindsOf(checked(before, now)).find(check::kFrozenNoiseKind) != std::string::npos;
}

// A lamp of radiance 4 in the middle of the wall.
io::FrameData withLamp(bool included, float most) {
  io::FrameData frame = planeFrame(0);
  frame.emission = io::Image(kPlaneWidth, kPlaneHeight, 3);
  for (int y = 40; y < 50; ++y)
    for (int x = 70; x < 90; ++x)
      for (int c = 0; c < 3; ++c) {
        frame.emission.at(x, y, c) = 4.0f;
        frame.albedo.at(x, y, c) = 0.0f;
        frame.radiance.at(x, y, c) = included ? 4.0f : 0.0f;
      }
  for (float& value : frame.radiance.pixels) value = std::min(value, most);
  return frame;
}

std::string kindsOf(const std::vector<Finding>& findings) {
  std::string kinds;
  for (const Finding& finding : findings) kinds += finding.kind + " ";
  return kinds;
}

}  // namespace

TEST_CASE("noise of its own in every frame is no cause for alarm", "[check]") {
  for (const bool moving : {false, true}) {
    const auto sequence = room(moving);
    for (int number = 0; number < 3; ++number) {
      const auto a = check::noiseResiduals(cli::viewOf(sequence->read(number)));
      const auto b = check::noiseResiduals(cli::viewOf(sequence->read(number + 1)));
      CHECK(check::noiseCorrelation(a, b).value() < 0.2);
    }
  }
  const auto colonnade = io::openSequence(kData);
  CHECK_FALSE(isFrozen(colonnade->read(4), colonnade->read(5)));
}

TEST_CASE("noise that stays the same is found, and views that stay the same", "[check]") {
  const io::FrameData still = room(false)->read(0);
  CHECK(isFrozen(still, numbered(still, 1)));
  CHECK(check::isStill(cli::viewOf(still)));
  // Under a camera that moves history has the noise of other pixels.
  const io::FrameData moving = room(true)->read(0);
  CHECK(isFrozen(moving, numbered(moving, 1)));
  CHECK_FALSE(check::isStill(cli::viewOf(moving)));
}

TEST_CASE("frames in a row are compared, and only where noise can be told from texture", "[check]") {
  const io::FrameData frame = room(false)->read(0);
  CHECK_FALSE(isFrozen(frame, numbered(frame, 2)));
  CHECK_FALSE(isFrozen(withoutNoise(frame), numbered(withoutNoise(frame), 1)));
  io::FrameData withoutAlbedo = frame;
  withoutAlbedo.albedo = {};
  CHECK_FALSE(isFrozen(withoutAlbedo, numbered(withoutAlbedo, 1)));
}

TEST_CASE("light of lamps must be part of radiance, and may be cut off", "[check]") {
  CHECK(tests::kindsOf(checked(withLamp(true, 100.0f))) == "");
  CHECK(tests::kindsOf(checked(withLamp(false, 100.0f))) == "emission-not-in-radiance ");
  CHECK(tests::kindsOf(checked(withLamp(true, 1.0f))) == "radiance-clamped ");
}

TEST_CASE("missing samples are counted, many of them doubtful", "[check]") {
  io::FrameData frame = planeFrame(0);
  frame.radiance.at(3, 4, 1) = std::numeric_limits<float>::quiet_NaN();
  frame.positionWorld.at(5, 6, 0) = std::numeric_limits<float>::infinity();
  frame.albedo.at(7, 8, 2) = std::numeric_limits<float>::quiet_NaN();
  const check::Result few = checked(frame);
  CHECK(tests::kindsOf(few) == "missing-samples broken-features broken-features ");
  CHECK(tests::kindsOf(few, Severity::Doubtful) == "");
  CHECK(few.findings[0].finding.pixels == 1);
  for (int x = 0; x < kPlaneWidth; ++x)
    for (int y = 0; y < 4; ++y) frame.radiance.at(x, y, 0) = -1.0f;
  CHECK(tests::kindsOf(checked(frame), Severity::Doubtful) == "negative-light ");
}

TEST_CASE("light that is mostly in fireflies, and none at all, are doubtful", "[check]") {
  io::FrameData frame = planeFrame(0);
  for (int y = 5; y < kPlaneHeight; y += 10)
    for (int x = 5; x < kPlaneWidth; x += 10)
      for (int c = 0; c < 3; ++c) frame.radiance.at(x, y, c) = 1000.0f;
  CHECK(tests::kindsOf(checked(frame), Severity::Doubtful) == "fireflies ");
  std::fill(frame.radiance.pixels.begin(), frame.radiance.pixels.end(), 0.0f);
  CHECK(tests::kindsOf(checked(frame), Severity::Doubtful) == "radiance-black ");
}

TEST_CASE("references must be two, finite, and as bright as the frame", "[check]") {
  const io::FrameData frame = planeFrame(0);
  io::Image a = planeFrame(0).radiance, b = planeFrame(1).radiance;
  const auto told = [&](const io::Image& half) {
    return kindsOf(check::checkReference(cli::viewOf(frame.radiance), cli::viewOf(a), cli::viewOf(half)));
  };
  CHECK(told(b) == "");
  CHECK(told(io::Image()) == "");
  CHECK(told(a) == "reference-halves-identical ");
  b.pixels[17] = std::numeric_limits<float>::quiet_NaN();
  CHECK(told(b) == "reference-broken ");
  for (float& value : a.pixels) value /= 4.0f;
  CHECK(told(io::Image()) == "brightness-differs ");
}
