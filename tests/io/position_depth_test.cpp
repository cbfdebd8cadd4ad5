#include "host/io/position_depth.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "host/io/depth_kind.hpp"
#include "host/io/multilayer_camera.hpp"
#include "tests/support/multilayer_files.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using namespace quell::tests;

namespace {

double largestDepthError(const FrameData& frame, const Image& depth) {
  const Image truth = multilayer::depthOf(frame);
  double largest = 0.0;
  for (int y = 0; y < multilayer::kHeight; ++y)
    for (int x = 0; x < multilayer::kWidth; ++x)
      if (!multilayer::isSky(frame, x, y))
        largest = std::max(largest, std::abs(double(depth.at(x, y, 0)) / truth.at(x, y, 0) - 1.0));
  return largest;
}

double errorOf(const FrameData& frame, const Image& positions) {
  const FoundCamera found = findCamera(positions, viewDepthFromPositions(positions, frame.normalWorld));
  INFO(found.failure);
  REQUIRE(found.worldToClip);
  return multilayer::projectionError(*found.worldToClip, frame.camera.worldToClip, frame);
}

}  // namespace

TEST_CASE("depth and a camera follow from positions alone") {
  for (const int number : {0, 3}) {
    const FrameData frame = multilayer::builtIn()->read(number);
    CHECK(largestDepthError(frame, viewDepthFromPositions(frame.positionWorld, frame.normalWorld)) < 1e-4);
    CHECK(errorOf(frame, frame.positionWorld) < 1e-3);
  }
}

TEST_CASE("depth from positions is in the scene's units, wherever that lies") {
  const FrameData frame = multilayer::builtIn()->read(3);
  Image moved = frame.positionWorld;
  for (std::size_t i = 0; i < moved.pixels.size(); ++i)
    moved.pixels[i] = 100.0f * moved.pixels[i] + (i % 3 == 0 ? 300.0f : -50.0f);
  Image depth = viewDepthFromPositions(moved, frame.normalWorld);
  for (float& value : depth.pixels)
    if (value != kNoSurfaceDepth) value /= 100.0f;
  CHECK(largestDepthError(frame, depth) < 1e-3);
}

TEST_CASE("a quarter of broken positions, and some that are no numbers, do not spoil depth from positions") {
  const FrameData frame = multilayer::builtIn()->read(3);
  const Image noise = noiseImage(multilayer::kWidth, multilayer::kHeight, 3, 5, -20.0f, 20.0f);
  Image position = frame.positionWorld;
  for (int y = 0; y < multilayer::kHeight; ++y)
    for (int x = y % 4; x < multilayer::kWidth; x += 4)
      for (int axis = 0; axis < 3; ++axis) position.at(x, y, axis) = noise.at(x, y, axis);
  position.at(21, 30, 1) = std::numeric_limits<float>::quiet_NaN();
  position.at(22, 30, 1) = std::numeric_limits<float>::infinity();
  position.at(23, 31, 0) = 1e30f;
  CHECK(errorOf(frame, position) < 0.1);
}

TEST_CASE("positions that tell no depth are at depth 1, and no camera follows") {
  Image plane(multilayer::kWidth, multilayer::kHeight, 3), normal(plane.width, plane.height, 3, 0.5f);
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) {
      plane.at(x, y, 0) = float(x);
      plane.at(x, y, 1) = float(y);
    }
  const Image depth = viewDepthFromPositions(plane, normal);
  CHECK(depth.at(3, 4, 0) == 1.0f);
  CHECK_FALSE(findCamera(plane, depth).worldToClip);
  CHECK(viewDepthFromPositions(plane, Image(plane.width, plane.height, 3)).at(3, 4, 0) == kNoSurfaceDepth);
  // Without perspective: any height over an orthographic picture.
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) plane.at(x, y, 2) = float((x * 7 + y * 3) % 11);
  CHECK(viewDepthFromPositions(plane, normal).at(3, 4, 0) == 1.0f);
}
