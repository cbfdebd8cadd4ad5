#include "host/io/depth_kind.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/support/error_matcher.hpp"
#include "tests/support/multilayer_files.hpp"

using namespace quell::io;
using quell::Error;
using quell::ErrorCode;
using quell::Matrix4;
using quell::tests::failsWith;
using namespace quell::tests::multilayer;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Image rowOf(const std::vector<float>& values) {
  Image image(int(values.size()), 1, 1);
  image.pixels = values;
  return image;
}

// Distance from the eye, which rows 0, 1 and 3 of the matrix map to zero, by way of a step along the view axis.
Image distancesOf(const FrameData& frame, const std::array<double, 3>& eye) {
  Image distance(kWidth, kHeight, 1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (!isSky(frame, x, y))
        distance.at(x, y, 0) = float(std::hypot(frame.positionWorld.at(x, y, 0) - eye[0],
                                                frame.positionWorld.at(x, y, 1) - eye[1],
                                                frame.positionWorld.at(x, y, 2) - eye[2]));
  return distance;
}

}  // namespace

TEST_CASE("kinds of depth have names", "[depth kinds]") {
  for (const std::string& name : depthKindNames()) CHECK(toString(parseDepthKind(name)) == name);
  REQUIRE_THROWS_MATCHES(parseDepthKind("z"), Error,
                         failsWith(ErrorCode::InvalidArgument, {"view, ray, hyperbolic, reversed", "got z"}));
}

TEST_CASE("a depth buffer becomes view depth", "[depth kinds]") {
  DepthCamera camera;
  camera.range = DepthRange{0.5, 100.0};
  const std::vector<float> views = {0.5f, 1.0f, 7.0f, 99.0f};
  for (const float view : views) {
    const double hyperbolic = (1.0 / 0.5 - 1.0 / view) / (1.0 / 0.5 - 1.0 / 100.0);
    const auto back = [&](DepthKind kind, double value) {
      return viewDepthOf(rowOf({float(value)}), kind, camera, "z.exr").at(0, 0, 0);
    };
    CHECK(back(DepthKind::Hyperbolic, hyperbolic) == Approx(view).epsilon(1e-4));
    CHECK(back(DepthKind::Reversed, 1.0 - hyperbolic) == Approx(view).epsilon(1e-4));
  }
  for (const float value : {1.0f, 1.5f, -0.1f, kNan})
    CHECK(viewDepthOf(rowOf({value}), DepthKind::Hyperbolic, camera, "").at(0, 0, 0) == kNoSurfaceDepth);
  camera.range->far.reset();
  CHECK(viewDepthOf(rowOf({0.01f}), DepthKind::Reversed, camera, "").at(0, 0, 0) == Approx(50.0));
  CHECK(viewDepthOf(rowOf({0.0f}), DepthKind::Reversed, camera, "").at(0, 0, 0) == kNoSurfaceDepth);
  REQUIRE_THROWS_MATCHES(viewDepthOf(rowOf({0.0f}), DepthKind::Hyperbolic, camera, "z.exr"), Error,
                         failsWith(ErrorCode::FileError, {"z.exr", "\"far\"", "hyperbolic"}));
  REQUIRE_THROWS_MATCHES(viewDepthOf(rowOf({0.0f}), DepthKind::Reversed, {}, "z.exr"), Error,
                         failsWith(ErrorCode::FileError, {"z.exr", "\"near\"", "reversed"}));
}

TEST_CASE("distances along rays become view depth", "[depth kinds]") {
  const FrameData frame = builtIn()->read(0);
  DepthCamera camera;
  camera.worldToClip = frame.camera.worldToClip;
  // Rays that go through one point: the eye is where those of two corners meet, as rows 0, 1 and 3 say.
  const Matrix4& m = *camera.worldToClip;
  const auto determinant = [](const std::array<double, 3>& a, const std::array<double, 3>& b,
                              const std::array<double, 3>& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  std::array<double, 3> eye{};
  std::array<std::array<double, 3>, 3> columns;
  for (std::size_t c = 0; c < 3; ++c) columns[c] = {m[c], m[4 + c], m[12 + c]};
  for (std::size_t c = 0; c < 3; ++c) {
    auto replaced = columns;
    replaced[c] = {-m[3], -m[7], -m[15]};
    eye[c] =
        determinant(replaced[0], replaced[1], replaced[2]) / determinant(columns[0], columns[1], columns[2]);
  }
  const Image view = viewDepthOf(distancesOf(frame, eye), DepthKind::Ray, camera, "z.exr");
  const Image expected = depthOf(frame);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) REQUIRE(view.at(x, y, 0) == Approx(expected.at(x, y, 0)).epsilon(1e-3));
  REQUIRE_THROWS_MATCHES(viewDepthOf(rowOf({1.0f}), DepthKind::Ray, {}, "z.exr"), Error,
                         failsWith(ErrorCode::FileError, {"z.exr", "a camera"}));
  camera.worldToClip = Matrix4{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  REQUIRE_THROWS_MATCHES(viewDepthOf(rowOf({1.0f}), DepthKind::Ray, camera, "z.exr"), Error,
                         failsWith(ErrorCode::FileError, {"orthographic"}));
}
