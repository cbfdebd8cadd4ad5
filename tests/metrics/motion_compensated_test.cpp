#include "host/metrics/motion_compensated.hpp"

#include <catch2/catch.hpp>

#include "tests/support/error_matcher.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::metrics;
using quell::Error;
using quell::ErrorCode;
using quell::Matrix4;
using quell::io::Image;
using quell::tests::constantImage;
using quell::tests::failsWith;

namespace {

constexpr int kWidth = 320, kHeight = 180;
constexpr double kDepth = 4.0;  // of a wall that faces the camera

// Looks along -z from (cameraX, 0, 0); at depth 4 the image is 8 units wide and 4.5 high.
Matrix4 lookFrom(double cameraX) {
  return {1, 0, 0, -cameraX, 0, 16.0 / 9.0, 0, 0, 0, 0, -1, -1, 0, 0, -1, 0};
}

// A wall whose brightness is a ramp in world x, seen from cameraX through pixel centres; its positions and normals
// through pixel centres and jitter.
TrackedFrame wall(double cameraX, double cameraXPrev, float brighter = 0.0f,
                  std::array<double, 2> jitterPx = {0.0, 0.0}) {
  TrackedFrame frame{
      Image(kWidth, kHeight, 3), Image(kWidth, kHeight, 3), Image(kWidth, kHeight, 3), {}, {}, {}};
  frame.camera.worldToClip = lookFrom(cameraX);
  frame.camera.worldToClipPrev = lookFrom(cameraXPrev);
  frame.camera.jitterPx = jitterPx;
  const double unitsPerPx = 2.0 * kDepth / kWidth;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double worldX = cameraX + kDepth * (2.0 * (x + 0.5) / kWidth - 1.0);
      const double worldY = 9.0 / 16.0 * kDepth * (1.0 - 2.0 * (y + 0.5) / kHeight);
      frame.positionWorld.at(x, y, 0) = float(worldX + unitsPerPx * jitterPx[0]);
      frame.positionWorld.at(x, y, 1) = float(worldY - unitsPerPx * jitterPx[1]);
      frame.positionWorld.at(x, y, 2) = float(-kDepth);
      frame.normalWorld.at(x, y, 2) = 1.0f;
      for (int c = 0; c < 3; ++c) frame.encoded.at(x, y, c) = float(0.3 + 0.02 * worldX) + brighter;
    }
  }
  return frame;
}

double errorOf(const TrackedFrame& before, const TrackedFrame& now) {
  MotionCompensatedErrorMeter meter;
  meter.add(before);
  REQUIRE_FALSE(meter.mean().has_value());
  meter.add(now);
  return meter.mean().value();
}

}  // namespace

TEST_CASE("a static view gives the plain luma difference") {
  REQUIRE(errorOf(wall(0.0, 0.0), wall(0.0, 0.0, 0.1f)) == Approx(0.1).epsilon(1e-4));
  REQUIRE(errorOf(wall(0.0, 0.0), wall(0.0, 0.0)) < 1e-6);
}

TEST_CASE("jitter is no motion: pictures are compared pixel centre by pixel centre") {
  const TrackedFrame before = wall(0.0, 0.0, 0.0f, {-0.25, 0.125}), now = wall(0.0, 0.0, 0.0f, {0.4, -0.5});
  REQUIRE(errorOf(before, now) < 1e-6);
}

TEST_CASE("a moving camera over a wall that keeps its light gives no error, a flicker does") {
  for (const double step : {0.025, 0.01}) {  // one pixel, two fifths of one
    REQUIRE(errorOf(wall(0.0, 0.0), wall(step, 0.0)) < 1e-5);
    REQUIRE(errorOf(wall(0.0, 0.0), wall(step, 0.0, 0.1f)) == Approx(0.1).epsilon(1e-3));
  }
}

TEST_CASE("background and surfaces that were not visible before do not count") {
  TrackedFrame now = wall(0.0, 0.0, 0.1f);
  for (int y = 0; y < kHeight; ++y) {
    now.normalWorld.at(3, y, 2) = 0.0f;     // background
    now.positionWorld.at(5, y, 2) = -3.0f;  // something that came nearer
    for (int c = 0; c < 3; ++c) now.encoded.at(3, y, c) = now.encoded.at(5, y, c) = 1.0f;
  }
  REQUIRE(errorOf(wall(0.0, 0.0), now) == Approx(0.1).epsilon(1e-3));
}

// The whole wall as an object that slid to the right by this many pixels since the frame before.
TrackedFrame slidWall(int pixels, float brighter = 0.0f) {
  TrackedFrame frame = wall(0.0, 0.0, brighter);
  frame.motion = Image(kWidth, kHeight, 2);
  frame.objectId = Image(kWidth, kHeight, 1, 7.0f);
  const double unitsPerPixel = 2.0 * kDepth / kWidth;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      frame.motion.at(x, y, 0) = float(-pixels);
      for (int c = 0; c < 3; ++c) frame.encoded.at(x, y, c) -= float(0.02 * pixels * unitsPerPixel);
    }
  }
  return frame;
}

TEST_CASE("what moves is followed by motion vectors where the object is the same") {
  const TrackedFrame before = slidWall(0);
  REQUIRE(errorOf(before, slidWall(9)) < 1e-5);
  REQUIRE(errorOf(before, slidWall(9, 0.1f)) == Approx(0.1).epsilon(1e-3));
  // Without ids the wall counts as standing still: as bright as nine pixels beside.
  TrackedFrame withoutIds = slidWall(9);
  withoutIds.objectId = Image();
  REQUIRE(errorOf(before, withoutIds) == Approx(0.02 * 9 * 2.0 * kDepth / kWidth).epsilon(1e-2));
  // Another object was there before, or the same one's ids stand for two things, one in front of the other.
  TrackedFrame other = before, nearer = before;
  other.objectId = Image(kWidth, kHeight, 1, 8.0f);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) nearer.positionWorld.at(x, y, 2) = float(-0.8 * kDepth);
  for (const TrackedFrame& unlike : {other, nearer}) {
    MotionCompensatedErrorMeter meter;
    meter.add(unlike);
    meter.add(slidWall(9));
    REQUIRE_FALSE(meter.mean().has_value());
  }
}

TEST_CASE("the motion-compensated error needs images of one size") {
  MotionCompensatedErrorMeter meter;
  TrackedFrame frame = wall(0.0, 0.0);
  frame.normalWorld = constantImage(4, 3, 0.0f);
  REQUIRE_THROWS_MATCHES(meter.add(frame), Error, failsWith(ErrorCode::InvalidArgument));
}
