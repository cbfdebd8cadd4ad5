#include "host/io/exr_camera.hpp"

#include <ImfHeader.h>
#include <ImfMatrixAttribute.h>

#include <catch2/catch.hpp>
#include <memory>

#include "host/io/camera_convention.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/exr_parts.hpp"
#include "tests/support/multilayer_files.hpp"
#include "tests/support/temporary_directory.hpp"

using namespace quell::io;
using quell::Matrix4;
using namespace quell::tests::multilayer;

namespace {

constexpr PixelWindow kWhole{0, 0, kWidth, kHeight};

ExrHeader headerWith(const char* name, const Matrix4& matrix, double screenWidth = 1.0) {
  const auto header = std::make_shared<Imf::Header>(kWidth, kHeight);
  Imath::M44f value;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      value[column][row] = float(matrix[std::size_t(4 * row + column)]);
  header->insert(name, Imf::M44fAttribute(value));
  header->screenWindowWidth() = float(screenWidth);
  ExrHeader result;
  result.windows = {kWhole, kWhole};
  result.attributes = header;
  return result;
}

// Clip rows in a form that renderers have.
Matrix4 scaledRows(Matrix4 m, double x, double shiftX, double y, double shiftY) {
  for (std::size_t column = 0; column < 4; ++column) {
    m[column] = x * m[column] + shiftX * m[12 + column];
    m[4 + column] = y * m[4 + column] + shiftY * m[12 + column];
  }
  return m;
}

std::optional<Matrix4> headerCamera(const ExrHeader& header, const Image& positions) {
  const std::vector<Matrix4> cameras = headerCameras(header);
  const auto index = fittingCamera(cameras, positions);
  return index ? std::optional(cameras.at(*index)) : std::nullopt;
}

}  // namespace

TEST_CASE("cameras of OpenEXR headers are found whatever the convention", "[exr camera]") {
  const FrameData frame = builtIn()->read(3);
  const Matrix4& m = frame.camera.worldToClip;
  const double aspect = double(kWidth) / kHeight;
  const Matrix4 forms[] = {m,
                           readAs({"", true, false}, m),
                           scaledRows(m, 0.5, 0.5, -0.5, 0.5),
                           scaledRows(m, 0.5, 0.5, 0.5, 0.5),
                           scaledRows(m, 0.5 * aspect, 0.5, 0.5, 0.5),
                           readAs({"", true, false}, scaledRows(m, aspect, 0.0, 1.0, 0.0))};
  for (const Matrix4& form : forms) {
    const auto found = headerCamera(headerWith("worldToNDC", form), frame.positionWorld);
    REQUIRE(found);
    CHECK(projectionError(*found, m, frame) < 0.01);
  }
  // Without positions the convention of OpenEXR's documentation counts.
  const auto first = headerCamera(headerWith("worldToNDC", m), Image());
  REQUIRE(first);
  CHECK(projectionError(*first, m, frame) < 0.01);
  Matrix4 other = m;
  other[3] += 100.0;
  CHECK_FALSE(headerCamera(headerWith("worldToNDC", other), frame.positionWorld));
  CHECK_FALSE(headerCamera(headerWith("somethingElse", m), frame.positionWorld));
}

TEST_CASE("a camera by worldToCamera and the screen window", "[exr camera]") {
  const FrameData frame = builtIn()->read(3);
  const Matrix4& m = frame.camera.worldToClip;
  // Rows of unit length; the view axis along z, or against it.
  const auto lengthOf = [&](std::size_t row) {
    return std::sqrt(m[4 * row] * m[4 * row] + m[4 * row + 1] * m[4 * row + 1] +
                     m[4 * row + 2] * m[4 * row + 2]);
  };
  for (const double axis : {1.0, -1.0}) {
    Matrix4 view{};
    for (std::size_t column = 0; column < 4; ++column) {
      view[column] = m[column] / lengthOf(0);
      view[4 + column] = m[4 + column] / lengthOf(1);
      view[8 + column] = axis * m[12 + column] / lengthOf(3);
    }
    view[15] = 1.0;
    const double screenWidth = 2.0 * lengthOf(3) / lengthOf(0);
    const auto found = headerCamera(headerWith("worldToCamera", view, screenWidth), frame.positionWorld);
    REQUIRE(found);
    CHECK(projectionError(*found, m, frame) < 0.01);
  }
}

TEST_CASE("a multilayer file needs no depth where its header has a camera", "[exr camera]") {
  const quell::tests::TemporaryDirectory directory;
  const FrameData frame = builtIn()->read(3);
  quell::tests::Planes planes;
  quell::tests::addPlanes(planes, "L.Combined", frame.radiance, "RGB");
  quell::tests::addPlanes(planes, "L.Normal", frame.normalWorld, "XYZ");
  quell::tests::addPlanes(planes, "L.Position", frame.positionWorld, "XYZ");
  const auto write = [&](const Matrix4& matrix) {
    quell::tests::writePlanes(directory.file("1.exr"), planes, *headerWith("worldToNDC", matrix).attributes);
    return openSequence(directory.path())->read(1);
  };
  CHECK(projectionError(write(frame.camera.worldToClip).camera.worldToClip, frame.camera.worldToClip, frame) <
        0.01);
  Matrix4 other = frame.camera.worldToClip;
  other[3] += 100.0;
  // One that puts positions elsewhere than their pixels does not count: they tell the camera themselves.
  CHECK(projectionError(write(other).camera.worldToClip, frame.camera.worldToClip, frame) < 0.01);
}
