// Cameras from what renderers have.
#include <quell/quell.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

// Clip coordinates of a point.
std::array<double, 4> project(const Matrix4& m, const std::array<double, 3>& p) {
  std::array<double, 4> clip{};
  for (std::size_t row = 0; row < 4; ++row)
    clip[row] = m[4 * row] * p[0] + m[4 * row + 1] * p[1] + m[4 * row + 2] * p[2] + m[4 * row + 3];
  return clip;
}

}  // namespace

TEST_CASE("a camera that looks at a point shows it in the middle", "[core]") {
  const Matrix4 m = lookAt({1, 2, 3}, {1, 2, -7}, {0, 5, 0}, 90.0, 2.0);
  const auto middle = project(m, {1, 2, -7});
  CHECK(middle[0] == Approx(0.0).margin(1e-12));
  CHECK(middle[1] == Approx(0.0).margin(1e-12));
  CHECK(middle[3] == Approx(10.0));
  const auto top = project(m, {1, 12, -7});  // 45 degrees up
  CHECK(top[1] / top[3] == Approx(1.0));
  const auto right = project(m, {21, 2, -7});
  CHECK(right[0] / right[3] == Approx(1.0));
}

TEST_CASE("a camera without a picture is refused", "[core]") {
  const auto refused = [](const char* name, const std::array<double, 3>& target, double fov, double aspect) {
    checkRefused({ErrorCode::InvalidArgument, "lookAt", name, "", ""}, [&] {
      lookAt({0, 0, 0}, target, {0, 1, 0}, fov, aspect);
    });
  };
  refused("target", {0, 0, 0}, 60.0, 1.0);
  refused("target", {0, 3, 0}, 60.0, 1.0);
  refused("target", {0, 0, std::nan("")}, 60.0, 1.0);
  refused("verticalFovDegrees", {0, 0, -1}, 180.0, 1.0);
  refused("aspect", {0, 0, -1}, 60.0, 0.0);
}

TEST_CASE("matrices of floats are read in either order", "[core]") {
  float rows[16], columns[16];
  Matrix4 expected;
  for (std::size_t i = 0; i < 16; ++i) {
    expected[i] = double(i) + 0.5;
    rows[i] = float(expected[i]);
    columns[4 * (i % 4) + i / 4] = rows[i];
  }
  CHECK(toMatrix4(rows, MatrixOrder::Rows) == expected);
  CHECK(toMatrix4(columns, MatrixOrder::Columns) == expected);
  const Matrix4 move = {1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1};
  const Matrix4 scale = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1};
  CHECK(product(scale, move) == Matrix4{2, 0, 0, 2, 0, 2, 0, 4, 0, 0, 2, 6, 0, 0, 0, 1});
}

TEST_CASE("C sets cameras as C++ does", "[core]") {
  quell_camera camera{};
  const double eye[3] = {1, 2, 3}, target[3] = {0, 0, 0}, up[3] = {0, 1, 0};
  REQUIRE(quellSetLookAt(&camera, eye, target, up, 50.0, 1.5) == QUELL_SUCCESS);
  const Matrix4 expected = lookAt({1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 50.0, 1.5);
  CHECK(std::equal(expected.begin(), expected.end(), camera.worldToClip));
  CHECK(quellSetLookAt(&camera, eye, eye, up, 50.0, 1.5) == QUELL_INVALID_ARGUMENT);
  CHECK(std::equal(expected.begin(), expected.end(), camera.worldToClip));

  float clip[16], view[16];
  for (int i = 0; i < 16; ++i) {
    clip[i] = float(i);
    view[i] = float(i * i % 7);
  }
  REQUIRE(quellSetMatrices(&camera, clip, view, QUELL_COLUMNS) == QUELL_SUCCESS);
  const Matrix4 both = product(toMatrix4(clip, MatrixOrder::Columns), toMatrix4(view, MatrixOrder::Columns));
  CHECK(std::equal(both.begin(), both.end(), camera.worldToClip));
  REQUIRE(quellSetMatrices(&camera, clip, nullptr, QUELL_ROWS) == QUELL_SUCCESS);
  CHECK(camera.worldToClip[1] == 1.0);
  CHECK(quellSetMatrices(&camera, clip, view, 7) == QUELL_INVALID_ARGUMENT);
}

}  // namespace quell::tests
