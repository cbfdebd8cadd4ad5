// Cameras to reprojection parameters, against plain double-precision projection.
#include "host/core/reprojection.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/support/error_matcher.hpp"

namespace quell::tests {
namespace {

using Vector = std::array<double, 3>;

constexpr Size kSize{1280, 720};
// Rows are floats and pixel indices reach 1280: a few roundings of 2^-24 * 1280.
constexpr double kPixelTolerance = 2e-3;
const Vector kPoints[] = {{0.3, 0.2, -4.0}, {-2.0, 1.0, -7.5}, {1.5, -0.8, -3.0}, {0.0, 0.0, -40.0}};

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector add(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

// Columns of a matrix from its rows; the camera stands at `origin`.
Matrix4 fromRows(const Vector& x, const Vector& y, const Vector& w, const Vector& origin) {
  return {x[0], x[1], x[2], -dot(x, origin), y[0], y[1], y[2], -dot(y, origin), 0, 0, 0, 0,
          w[0], w[1], w[2], -dot(w, origin)};
}

// A camera that looks along -z, turned by `yaw` to the left; vertical half field of view atan(1 / 1.5).
Matrix4 perspective(const Vector& origin, double yaw = 0.0, double wScale = 1.0) {
  const double c = std::cos(yaw), s = std::sin(yaw), focal = 1.5 * wScale;
  const double aspect = double(kSize.width) / kSize.height;
  return fromRows({c * focal / aspect, 0, -s * focal / aspect}, {0, focal, 0}, {-s * wScale, 0, -c * wScale},
                  origin);
}

Matrix4 orthographic(const Vector& origin, double halfHeight) {
  const double aspect = double(kSize.width) / kSize.height;
  Matrix4 m = fromRows({1 / (halfHeight * aspect), 0, 0}, {0, 1 / halfHeight, 0}, {0, 0, 0}, origin);
  m[15] = 1.0;
  return m;
}

// Clip coordinates of a world position.
Vector clip(const Matrix4& m, const Vector& p) {
  Vector result{};
  const int rows[] = {0, 1, 3};
  for (std::size_t i = 0; i < 3; ++i) {
    const double* row = &m[4 * std::size_t(rows[i])];
    result[i] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
  }
  return result;
}

// Where a world position lies in the image, in pixels from the top left corner.
std::array<double, 2> imagePosition(const Matrix4& m, const Vector& p) {
  const Vector c = clip(m, p);
  return {(0.5 + 0.5 * c[0] / c[2]) * kSize.width, (0.5 - 0.5 * c[1] / c[2]) * kSize.height};
}

double affine(const QuellFloat4& row, const std::array<float, 3>& p) {
  return double(row.x * p[0] + row.y * p[1] + row.z * p[2] + row.w);
}

// As a kernel makes it: (position - high) - low in float.
std::array<float, 3> relative(const ReprojectionParams& params, const Vector& world) {
  return {(float(world[0]) - params.cameraHigh.x) - params.cameraLow.x,
          (float(world[1]) - params.cameraHigh.y) - params.cameraLow.y,
          (float(world[2]) - params.cameraHigh.z) - params.cameraLow.z};
}

std::array<double, 2> pixelPrev(const ReprojectionParams& params, const Vector& world) {
  const auto p = relative(params, world);
  const double w = affine(params.clipWPrev, p);
  return {affine(params.pixelXPrev, p) / w, affine(params.pixelYPrev, p) / w};
}

std::array<double, 2> pixelNow(const ReprojectionParams& params, const Vector& world) {
  const auto p = relative(params, world);
  const double w = affine(params.clipW, p);
  return {affine(params.pixelX, p) / w, affine(params.pixelY, p) / w};
}

// Rounded to float, as a caller's position buffer holds it. Volatile: see roundedToFloat in reprojection.cpp.
Vector rounded(const Vector& p) {
  const volatile float values[] = {float(p[0]), float(p[1]), float(p[2])};
  return {values[0], values[1], values[2]};
}

ReprojectionParams paramsOf(const Camera& camera) {
  return makeReprojectionParams(camera, kSize, {0.5, 8.0, 0.1}, true);
}

void checkPoint(const Camera& camera, const Vector& point) {
  const ReprojectionParams params = paramsOf(camera);
  const Vector p = rounded(point);
  const auto expected = imagePosition(camera.worldToClipPrev, p);
  const auto got = pixelPrev(params, p);
  INFO("point " << p[0] << ", " << p[1] << ", " << p[2]);
  CHECK(std::abs(got[0] - (expected[0] - 0.5)) < kPixelTolerance);
  CHECK(std::abs(got[1] - (expected[1] - 0.5)) < kPixelTolerance);
  const auto expectedNow = imagePosition(camera.worldToClip, p);
  const auto gotNow = pixelNow(params, p);
  CHECK(std::abs(gotNow[0] - (expectedNow[0] - 0.5)) < kPixelTolerance);
  CHECK(std::abs(gotNow[1] - (expectedNow[1] - 0.5)) < kPixelTolerance);
}

}  // namespace

TEST_CASE("a camera that stands still sends every pixel to itself wherever its samples lie", "[core]") {
  Camera camera;
  camera.worldToClip = perspective({10, -20, 30}, 0.3);
  camera.worldToClipPrev = camera.worldToClip;
  camera.jitterPx = GENERATE(std::array{0.0, 0.0}, std::array{0.4375, -0.3}, std::array{-1.0, 1.0});
  const ReprojectionParams params = paramsOf(camera);
  CHECK(params.historyValid == 1);
  for (const float motion : {params.cameraMotion.x, params.cameraMotion.y, params.cameraMotion.z})
    CHECK(motion == 0.0f);
  for (const int x : {0, 1, 640, 1279}) {
    for (const int y : {0, 359, 719}) {
      for (const float depth : {0.1f, 3.0f, 1000.0f}) {
        const std::array<float, 3> p = {
            depth * (params.rayOrigin.x + float(x) * params.rayX.x + float(y) * params.rayY.x),
            depth * (params.rayOrigin.y + float(x) * params.rayX.y + float(y) * params.rayY.y),
            depth * (params.rayOrigin.z + float(x) * params.rayX.z + float(y) * params.rayY.z)};
        const double w = affine(params.clipW, p), wPrev = affine(params.clipWPrev, p);
        CHECK(std::abs(affine(params.pixelX, p) / w - x - camera.jitterPx[0]) < kPixelTolerance);
        CHECK(std::abs(affine(params.pixelY, p) / w - y - camera.jitterPx[1]) < kPixelTolerance);
        CHECK(affine(params.pixelXPrev, p) / wPrev == affine(params.pixelX, p) / w);
        CHECK(affine(params.pixelYPrev, p) / wPrev == affine(params.pixelY, p) / w);
      }
    }
  }
}

TEST_CASE("a camera that moved and turned agrees with plain projection", "[core]") {
  Camera camera;
  camera.worldToClip = perspective({0.2, 0.1, 0.3}, 0.02);
  camera.worldToClipPrev = perspective({0.0, 0.05, 0.4}, -0.03);
  for (const Vector& point : kPoints) checkPoint(camera, point);
  const ReprojectionParams params = paramsOf(camera);
  CHECK(params.cameraMotion.x == Approx(-0.2));
  CHECK(params.cameraMotion.y == Approx(-0.05));
  CHECK(params.cameraMotion.z == Approx(0.1));
}

TEST_CASE("jitter is taken off as the camera documents it: x right, y down", "[core]") {
  Camera camera;
  camera.worldToClip = perspective({0, 0, 0});
  camera.worldToClipPrev = camera.worldToClip;
  camera.jitterPx = {0.375, -0.25};
  for (const Vector& point : kPoints) checkPoint(camera, point);
  const ReprojectionParams params = paramsOf(camera);
  constexpr double kColumn = 100, kRow = 200, kDepth = 3.0;
  const Vector point = {kDepth * (params.rayOrigin.x + kColumn * params.rayX.x + kRow * params.rayY.x),
                        kDepth * (params.rayOrigin.y + kColumn * params.rayX.y + kRow * params.rayY.y),
                        kDepth * (params.rayOrigin.z + kColumn * params.rayX.z + kRow * params.rayY.z)};
  const auto position = imagePosition(camera.worldToClip, point);
  CHECK(std::abs(position[0] - (kColumn + 0.5 + 0.375)) < kPixelTolerance);
  CHECK(std::abs(position[1] - (kRow + 0.5 - 0.25)) < kPixelTolerance);
}

TEST_CASE("rays reach the view depth in scene units whatever the scale of clip.w", "[core]") {
  for (const double wScale : {1.0, 0.01, 250.0}) {
    const double yaw = 0.4;
    Camera camera;
    camera.worldToClip = perspective({1, 2, 3}, yaw, wScale);
    camera.worldToClipPrev = camera.worldToClip;
    const ReprojectionParams params = paramsOf(camera);
    const Vector ray = {double(params.rayOrigin.x), double(params.rayOrigin.y), double(params.rayOrigin.z)};
    CHECK(dot(ray, {-std::sin(yaw), 0, -std::cos(yaw)}) == Approx(1.0));
  }
}

TEST_CASE("a camera far from the origin loses nothing to float", "[core]") {
  const Vector far = {1.0e6 + 0.123456789, -2.0e6 - 0.987654321, 3.0e5 + 0.5};
  Camera camera;
  camera.worldToClip = perspective(add(far, {0.013, 0.027, 0.041}), 0.02);
  camera.worldToClipPrev = perspective(far, 0.015);
  const ReprojectionParams params = paramsOf(camera);
  const Vector origin = add(far, {0.013, 0.027, 0.041});
  const double recovered[] = {double(params.cameraHigh.x) + params.cameraLow.x,
                              double(params.cameraHigh.y) + params.cameraLow.y,
                              double(params.cameraHigh.z) + params.cameraLow.z};
  for (std::size_t axis = 0; axis < 3; ++axis) CHECK(std::abs(recovered[axis] - origin[axis]) < 1e-7);
  CHECK(std::abs(params.cameraMotion.x + 0.013) < 1e-7);
  CHECK(std::abs(params.cameraMotion.y + 0.027) < 1e-7);
  CHECK(std::abs(params.cameraMotion.z + 0.041) < 1e-7);
  for (const Vector& point : kPoints) checkPoint(camera, add(far, point));
}

TEST_CASE("an orthographic camera agrees with plain projection and has no view rays", "[core]") {
  Camera camera;
  camera.worldToClip = orthographic({5.1, 2.2, 9.0}, 4.0);
  camera.worldToClipPrev = orthographic({5.0, 2.0, 9.0}, 4.0);
  CHECK(isOrthographic(camera.worldToClip));
  CHECK_FALSE(isOrthographic(perspective({0, 0, 0})));
  for (const double left : {1e-20, 1e-9, -1e-8}) {
    INFO(left);
    Camera rounded = camera;
    rounded.worldToClip[12] = left;
    CHECK(isOrthographic(rounded.worldToClip));
    CHECK_NOTHROW(makeReprojectionParams(rounded, kSize, {}, false));
  }
  for (const Vector& point : kPoints) checkPoint(camera, add(point, {5, 2, 0}));
  const ReprojectionParams params = paramsOf(camera);
  for (const QuellFloat4& ray : {params.rayOrigin, params.rayX, params.rayY})
    for (const float component : {ray.x, ray.y, ray.z}) CHECK(component == 0.0f);
  CHECK(params.clipW.w == 1.0f);
}

TEST_CASE("the camera's position is where clip x, y and w vanish", "[core]") {
  const Matrix4 m = perspective({-3.5, 7.25, 100.0}, 1.1);
  const Vector position = cameraPositionWorld(m, "worldToClip");
  for (const double component : clip(m, position)) CHECK(std::abs(component) < 1e-9);
  const Matrix4 flat = orthographic({5.1, 2.2, 9.0}, 4.0);
  const Vector middle = clip(flat, cameraPositionWorld(flat, "worldToClip"));
  CHECK(std::abs(middle[0]) < 1e-9);
  CHECK(std::abs(middle[1]) < 1e-9);
}

TEST_CASE("limits are passed on in scene units and in footprints of a pixel", "[core]") {
  Camera camera;
  camera.worldToClip = perspective({0, 0, 0});
  camera.worldToClipPrev = camera.worldToClip;
  const ReprojectionParams params = paramsOf(camera);
  CHECK(params.positionLimit == 0.5f);
  CHECK(params.normalLimitSquared == 0.1f);
  CHECK(params.positionLimitFootprint == Approx(8.0 * 2.0 / (kSize.height * 1.5)));
}

TEST_CASE("without history the camera before is not looked at", "[core]") {
  Camera camera;
  camera.worldToClip = perspective({0, 0, 0});
  camera.worldToClipPrev.fill(std::numeric_limits<double>::quiet_NaN());
  const ReprojectionParams params = makeReprojectionParams(camera, kSize, {}, false);
  CHECK(params.historyValid == 0);
  for (const float value :
       {params.pixelXPrev.x, params.pixelYPrev.y, params.clipWPrev.z, params.cameraMotion.x})
    CHECK(value == 0.0f);
}

TEST_CASE("a matrix that is no camera is refused by name", "[core]") {
  Camera good;
  good.worldToClip = perspective({1, 2, 3});
  good.worldToClipPrev = good.worldToClip;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Spoiled {
    Matrix4 Camera::*matrix;
    const char* name;
  };
  for (const Spoiled& spoiled :
       {Spoiled{&Camera::worldToClip, "worldToClip"}, Spoiled{&Camera::worldToClipPrev, "worldToClipPrev"}}) {
    for (const std::size_t element : {0, 5, 10, 15}) {
      for (const double value : {nan, std::numeric_limits<double>::infinity()}) {
        Camera camera = good;
        (camera.*spoiled.matrix)[element] = value;
        REQUIRE_THROWS_MATCHES(
            paramsOf(camera), Error,
            failsWith(ErrorCode::InvalidArgument, {std::string(spoiled.name) + ":", "finite"}));
      }
    }
    Camera camera = good;
    (camera.*spoiled.matrix) = Matrix4{};
    REQUIRE_THROWS_MATCHES(paramsOf(camera), Error,
                           failsWith(ErrorCode::InvalidArgument, {std::string(spoiled.name) + ":"}));
    camera = good;
    for (std::size_t i = 0; i < 4; ++i) (camera.*spoiled.matrix)[4 + i] = 2.0 * (camera.*spoiled.matrix)[i];
    REQUIRE_THROWS_MATCHES(
        paramsOf(camera), Error,
        failsWith(ErrorCode::InvalidArgument, {std::string(spoiled.name) + ":", "singular"}));
  }
}

TEST_CASE("jitter beyond a pixel or not a number is refused by name", "[core]") {
  Camera camera;
  camera.worldToClip = perspective({0, 0, 0});
  camera.worldToClipPrev = camera.worldToClip;
  for (const double value : {1.001, -1.5, std::numeric_limits<double>::quiet_NaN()}) {
    for (const std::size_t axis : {0, 1}) {
      Camera jittered = camera;
      jittered.jitterPx[axis] = value;
      REQUIRE_THROWS_MATCHES(paramsOf(jittered), Error, failsWith(ErrorCode::InvalidArgument, {"jitterPx:"}));
    }
  }
  camera.jitterPx = {1.0, -1.0};
  CHECK_NOTHROW(paramsOf(camera));
}

}  // namespace quell::tests
