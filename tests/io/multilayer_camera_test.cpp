#include "host/io/multilayer_camera.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/multilayer_files.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using quell::Matrix4;
using quell::tests::noiseImage;
using namespace quell::tests::multilayer;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

void setPosition(Image& position, int x, int y, float value) {
  for (int axis = 0; axis < 3; ++axis) position.at(x, y, axis) = value;
}

// A wall that faces the camera, one unit a pixel.
Image wall() {
  Image plane(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      plane.at(x, y, 0) = float(x);
      plane.at(x, y, 1) = float(y);
    }
  return plane;
}

double errorOf(const Image& position, const Image& depth, const FrameData& frame) {
  const FoundCamera found = findCamera(position, depth);
  INFO(found.failure);
  REQUIRE(found.worldToClip.has_value());
  return projectionError(*found.worldToClip, frame.camera.worldToClip, frame);
}

}  // namespace

TEST_CASE("one broken position or depth does not spoil the camera") {
  const FrameData frame = builtIn()->read(3);
  const Image depth = depthOf(frame);
  for (const float value : {kNan, kInfinity, -kInfinity, 1e10f, 1e30f, 100.0f}) {
    INFO(value);
    Image position = frame.positionWorld;
    setPosition(position, 30, 30, value);
    CHECK(errorOf(position, depth, frame) < 1e-3);
  }
  for (const float value : {kNan, kInfinity, -1.0f, 0.0f, 1e-6f, 1e8f}) {
    INFO(value);
    Image broken = depth;
    broken.at(30, 30, 0) = value;
    CHECK(errorOf(frame.positionWorld, broken, frame) < 1e-3);
  }
}

TEST_CASE("a quarter of the positions may be broken") {
  const FrameData frame = builtIn()->read(3);
  const Image noise = noiseImage(kWidth, kHeight, 3, 5, -20.0f, 20.0f);
  Image position = frame.positionWorld;
  for (int y = 0; y < kHeight; ++y)
    for (int x = (y % 4); x < kWidth; x += 4)
      for (int axis = 0; axis < 3; ++axis) position.at(x, y, axis) = noise.at(x, y, axis);
  CHECK(errorOf(position, depthOf(frame), frame) < 0.1);  // noise that happens to be near
}

TEST_CASE("no camera follows from a plane, from nothing, or from depth that does not fit") {
  const FrameData frame = builtIn()->read(3);
  const Image nothing(kWidth, kHeight, 1, 1e10f), flat(kWidth, kHeight, 1, 5.0f);
  const auto failureOf = [](const Image& position, const Image& depth) {
    const FoundCamera found = findCamera(position, depth);
    CHECK_FALSE(found.worldToClip.has_value());
    return found.failure;
  };
  using Catch::Contains;
  CHECK_THAT(failureOf(frame.positionWorld, nothing), Contains("no surfaces"));
  CHECK_THAT(failureOf(Image(kWidth, kHeight, 3, kNan), flat), Contains("no surfaces"));
  CHECK_THAT(failureOf(frame.positionWorld, noiseImage(kWidth, kHeight, 1, 3)), Contains("pixels off"));
  Image position = wall();
  CHECK_THAT(failureOf(position, flat), Contains("one plane"));
  setPosition(position, 30, 20, 7.0f);  // a broken pixel does not make it two
  CHECK_THAT(failureOf(position, flat), Contains("one plane"));
}

TEST_CASE("a camera that stands in has all surfaces before it") {
  Image normal(kWidth, kHeight, 3);
  for (std::size_t i = 0; i < normal.pixels.size(); i += 3) normal.pixels[i + 2] = -1.0f;
  Image position = wall();
  setPosition(position, 30, 20, 1e10f);
  const Matrix4 m = standInCamera(position, normal, Image(kWidth, kHeight, 1, 5.0f));
  CHECK(clipRow(m, 3, wall(), 0, 0) == Approx(5.0));
  CHECK(clipRow(m, 3, wall(), kWidth - 1, kHeight - 1) == Approx(5.0));
  const Matrix4 sky =
      standInCamera(Image(kWidth, kHeight, 3), Image(kWidth, kHeight, 3), Image(kWidth, kHeight, 1, 1e10f));
  CHECK(clipRow(sky, 3, Image(kWidth, kHeight, 3), 0, 0) == Approx(1.0));
}
