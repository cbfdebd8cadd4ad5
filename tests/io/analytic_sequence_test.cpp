// The built-in sequence keeps the buffer contract and repeats itself exactly.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <quell/error.hpp>
#include <vector>

#include "host/analytic/sequence.hpp"
#include "tests/support/error_matcher.hpp"

using quell::Error;
using quell::ErrorCode;
using quell::Matrix4;
using quell::io::AnalyticOptions;
using quell::io::FrameData;
using quell::io::FrameSequence;
using quell::io::Image;
using quell::io::makeAnalyticSequence;
using quell::io::ReferenceKind;
using Vec3 = std::array<double, 3>;

namespace {

AnalyticOptions optionsOfSize(int width, int height) {
  AnalyticOptions options;
  options.width = width;
  options.height = height;
  return options;
}

Vec3 pixelOf(const Image& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

double lengthOf(const Vec3& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/// Where a world point falls in the image, in pixels, (0.5, 0.5) being the centre of the top left pixel.
std::array<double, 2> project(const Matrix4& m, const Vec3& p, int width, int height) {
  const auto clip = [&](int r) {
    const double* row = &m[std::size_t(4 * r)];
    return row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
  };
  REQUIRE(clip(3) > 0.0);
  return {(clip(0) / clip(3) * 0.5 + 0.5) * width, (0.5 - clip(1) / clip(3) * 0.5) * height};
}

/// Largest distance in pixels between where any surface pixel was sampled and its position seen through `m`.
double largestMiss(const FrameData& data, const Matrix4& m) {
  double largest = 0.0;
  for (int y = 0; y < data.normalWorld.height; ++y) {
    for (int x = 0; x < data.normalWorld.width; ++x) {
      if (lengthOf(pixelOf(data.normalWorld, x, y)) == 0.0) continue;
      const auto at =
          project(m, pixelOf(data.positionWorld, x, y), data.normalWorld.width, data.normalWorld.height);
      largest = std::max(largest, std::hypot(at[0] - x - 0.5 - data.camera.jitterPx[0],
                                             at[1] - y - 0.5 - data.camera.jitterPx[1]));
    }
  }
  return largest;
}

/// Determinant of the matrix with columns u, v, w.
double determinant(const Vec3& u, const Vec3& v, const Vec3& w) {
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - v[0] * (u[1] * w[2] - u[2] * w[1]) +
         w[0] * (u[1] * v[2] - u[2] * v[1]);
}

/// The eye of a perspective camera: the one point where clip x, y and w are all zero, by Cramer's rule.
Vec3 eyeOf(const Matrix4& m) {
  const Vec3 x{m[0], m[4], m[12]};
  const Vec3 y{m[1], m[5], m[13]};
  const Vec3 z{m[2], m[6], m[14]};
  const Vec3 right{-m[3], -m[7], -m[15]};
  const double d = determinant(x, y, z);
  return {determinant(right, y, z) / d, determinant(x, right, z) / d, determinant(x, y, right) / d};
}

double backgroundShare(const FrameData& data) {
  int count = 0;
  for (int y = 0; y < data.normalWorld.height; ++y) {
    for (int x = 0; x < data.normalWorld.width; ++x)
      count += lengthOf(pixelOf(data.normalWorld, x, y)) == 0.0;
  }
  return double(count) / (data.normalWorld.width * data.normalWorld.height);
}

void requireContract(const FrameData& data, int x, int y) {
  INFO("pixel " << x << ", " << y);
  const double normalLength = lengthOf(pixelOf(data.normalWorld, x, y));
  const Vec3 albedo = pixelOf(data.albedo, x, y);
  const bool isBackground = normalLength == 0.0;
  if (!isBackground) REQUIRE(normalLength == Approx(1.0).margin(1e-6));
  if (isBackground) REQUIRE(lengthOf(pixelOf(data.positionWorld, x, y)) == 0.0);
  if (isBackground) REQUIRE(lengthOf(albedo) == 0.0);
  if (lengthOf(albedo) == 0.0) REQUIRE(pixelOf(data.radiance, x, y) == pixelOf(data.emission, x, y));
  for (const double value : albedo) REQUIRE((value >= 0.0 && value < 1.0));
  for (const double value : pixelOf(data.radiance, x, y)) REQUIRE((std::isfinite(value) && value >= 0.0));
}

}  // namespace

TEST_CASE("analytic sequence: every pixel keeps the contract, at any size", "[io]") {
  const auto [width, height] = GENERATE(table<int, int>({{1, 1}, {7, 93}, {257, 89}}));
  const auto sequence = makeAnalyticSequence(optionsOfSize(width, height));
  REQUIRE(sequence->width() == width);
  REQUIRE(sequence->height() == height);
  const FrameData data = sequence->read(3);
  REQUIRE(data.number == 3);
  REQUIRE(data.glossColor.empty());
  REQUIRE_FALSE(data.demodulated);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) requireContract(data, x, y);
  }
}

TEST_CASE("analytic sequence: a part of the image is background, most is not", "[io]") {
  const double share = backgroundShare(makeAnalyticSequence(optionsOfSize(160, 90))->read(0));
  REQUIRE(share > 0.05);
  REQUIRE(share < 0.25);
}

TEST_CASE("analytic sequence: normals face the camera", "[io]") {
  const FrameData data = makeAnalyticSequence(optionsOfSize(160, 90))->read(0);
  const Vec3 eye = eyeOf(data.camera.worldToClip);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 160; ++x) {
      const Vec3 n = pixelOf(data.normalWorld, x, y);
      const Vec3 p = pixelOf(data.positionWorld, x, y);
      if (lengthOf(n) == 0.0) continue;
      INFO("pixel " << x << ", " << y);
      REQUIRE(n[0] * (eye[0] - p[0]) + n[1] * (eye[1] - p[1]) + n[2] * (eye[2] - p[2]) > 0.0);
    }
  }
}

TEST_CASE("analytic sequence: positions project to their pixel's centre", "[io]") {
  const auto sequence = makeAnalyticSequence(optionsOfSize(320, 180));
  for (const int frame : {0, 1, 15}) {
    const FrameData data = sequence->read(frame);
    REQUIRE(largestMiss(data, data.camera.worldToClip) < 0.01);
  }
}

TEST_CASE("analytic sequence: jittered rays say so, and positions project to where they went", "[io]") {
  AnalyticOptions options = optionsOfSize(160, 90);
  REQUIRE_FALSE(makeAnalyticSequence(options)->jittered());
  options.jitter = true;
  const auto sequence = makeAnalyticSequence(options);
  REQUIRE(sequence->jittered());
  for (const int frame : {0, 5}) {
    const FrameData data = sequence->read(frame);
    REQUIRE(isJittered(data.camera));
    REQUIRE(largestMiss(data, data.camera.worldToClip) < 0.01);
  }
}

TEST_CASE("analytic sequence: the previous camera is the camera of the frame before", "[io]") {
  const auto sequence = makeAnalyticSequence(optionsOfSize(16, 9));
  REQUIRE(sequence->read(5).camera.worldToClipPrev == sequence->read(4).camera.worldToClip);
  const auto first = sequence->read(0).camera;
  REQUIRE(first.worldToClipPrev != first.worldToClip);

  AnalyticOptions still = optionsOfSize(16, 9);
  still.movingCamera = false;
  const auto camera = makeAnalyticSequence(still)->read(7).camera;
  REQUIRE(camera.worldToClipPrev == camera.worldToClip);
  REQUIRE(camera.worldToClip == first.worldToClip);
}

TEST_CASE("analytic sequence: the camera moves a few pixels per frame", "[io]") {
  const FrameData data = makeAnalyticSequence(optionsOfSize(1280, 720))->read(0);
  const double motionPx = largestMiss(data, data.camera.worldToClipPrev);
  CAPTURE(motionPx);
  REQUIRE(motionPx > 1.0);
  REQUIRE(motionPx < 12.0);
}

TEST_CASE("analytic sequence: equal options give equal pixels on any number of threads", "[io]") {
  AnalyticOptions options = optionsOfSize(61, 37);
  options.threadCount = 1;
  const FrameData once = makeAnalyticSequence(options)->read(2);
  options.threadCount = 5;
  const auto sequence = makeAnalyticSequence(options);
  const FrameData other = sequence->read(3);
  const FrameData again = sequence->read(2);
  REQUIRE(once.radiance.pixels == again.radiance.pixels);
  REQUIRE(once.normalWorld.pixels == again.normalWorld.pixels);
  REQUIRE(once.radiance.pixels != other.radiance.pixels);

  options.seed = 2;
  const FrameData reseeded = makeAnalyticSequence(options)->read(2);
  REQUIRE(once.radiance.pixels != reseeded.radiance.pixels);
  REQUIRE(once.albedo.pixels == reseeded.albedo.pixels);
}

TEST_CASE("analytic sequence: a world offset moves positions and camera, nothing else", "[io]") {
  AnalyticOptions options = optionsOfSize(64, 36);
  const FrameData near = makeAnalyticSequence(options)->read(1);
  options.worldOffset = {10000.0, -5000.0, 300.0};
  const FrameData far = makeAnalyticSequence(options)->read(1);
  REQUIRE(near.radiance.pixels == far.radiance.pixels);
  REQUIRE(near.normalWorld.pixels == far.normalWorld.pixels);
  REQUIRE(near.albedo.pixels == far.albedo.pixels);
  REQUIRE(near.emission.pixels == far.emission.pixels);
  REQUIRE(far.camera.worldToClip != near.camera.worldToClip);
  // A float near 10 km is right to 0.5 mm; the nearest surfaces are 3 m off, where a pixel is 78 mm wide.
  REQUIRE(largestMiss(far, far.camera.worldToClip) < 0.03);
  for (int y = 0; y < 36; ++y) {
    for (int x = 0; x < 64; ++x) {
      if (lengthOf(pixelOf(near.normalWorld, x, y)) == 0.0) {
        REQUIRE(lengthOf(pixelOf(far.positionWorld, x, y)) == 0.0);
        continue;
      }
      for (int c = 0; c < 3; ++c) {
        const double moved = far.positionWorld.at(x, y, c) - options.worldOffset[std::size_t(c)];
        REQUIRE(moved == Approx(near.positionWorld.at(x, y, c)).margin(5.0e-4));
      }
    }
  }
}

TEST_CASE("analytic sequence: frames outside the sequence are refused", "[io][errors]") {
  const auto sequence = makeAnalyticSequence(optionsOfSize(8, 8));
  REQUIRE(sequence->frames().size() == 16);
  REQUIRE(sequence->frames().front() == 0);
  REQUIRE(sequence->frames().back() == 15);
  REQUIRE_NOTHROW(sequence->read(15));
  for (const int frame : {-1, 16, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
    REQUIRE_THROWS_AS(sequence->read(frame), Error);
    REQUIRE_THROWS_AS(sequence->reference(frame, ReferenceKind::Centre), Error);
  }
}

TEST_CASE("analytic sequence: bad options are refused", "[io][errors]") {
  AnalyticOptions options;
  SECTION("no width") { options.width = 0; }
  SECTION("negative height") { options.height = -720; }
  SECTION("huge width") { options.width = 1 << 20; }
  SECTION("no frames") { options.frameCount = 0; }
  SECTION("negative frame count") { options.frameCount = -3; }
  SECTION("negative reference samples") { options.referenceSamples = -1; }
  SECTION("negative thread count") { options.threadCount = -1; }
  SECTION("offset is not a number") { options.worldOffset[1] = std::numeric_limits<double>::quiet_NaN(); }
  SECTION("infinite offset") { options.worldOffset[2] = std::numeric_limits<double>::infinity(); }
  REQUIRE_THROWS_MATCHES(makeAnalyticSequence(options), Error,
                         quell::tests::failsWith(ErrorCode::InvalidArgument));
}
