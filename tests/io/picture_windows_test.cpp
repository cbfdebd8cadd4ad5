// Sequences whose files hold parts of the picture: placed by window, or refused.
#include <catch2/catch.hpp>
#include <cmath>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/frame_sequence.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/exr_parts.hpp"
#include "tests/support/multilayer_files.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using namespace quell::tests;
using quell::Error;
using quell::ErrorCode;

namespace {

constexpr PixelWindow kDisplay{0, 0, multilayer::kWidth, multilayer::kHeight};
constexpr PixelWindow kPart{7, 5, 40, 30};

void writeCropped(const std::string& path, const Image& image, const PictureWindows& windows) {
  Planes planes;
  addPlanes(planes, "", placed(image, kDisplay, windows.data), "RGB");
  writePlanes(path, planes, windows);
}

std::string matrixText(const quell::Matrix4& m) {
  std::string text;
  for (std::size_t i = 0; i < 16; ++i)
    text += (i % 4 == 0 ? (i > 0 ? "],[" : "[[") : ",") + std::to_string(m[i]);
  return text + "]]";
}

/// Frame 0: the colour in one window, the features in another.
void writeSequence(const TemporaryDirectory& directory, const FrameData& frame, const PixelWindow& color,
                   const PixelWindow& features) {
  writeCropped(directory.file("color_0000.exr"), frame.radiance, {color, kDisplay});
  writeCropped(directory.file("shading_normal_0000.exr"), frame.normalWorld, {features, kDisplay});
  writeCropped(directory.file("world_position_0000.exr"), frame.positionWorld, {features, kDisplay});
  const std::string matrix = matrixText(frame.camera.worldToClip);
  writeTextFile(directory.file("camera.json"), "{\"frames\": [{\"frame\": 0, \"view_projection\": " + matrix +
                                                   ", \"previous_view_projection\": " + matrix + "}]}");
}

}  // namespace

TEST_CASE("a part of the picture is that part, with the camera for it") {
  const TemporaryDirectory directory;
  const FrameData original = multilayer::builtIn()->read(0);
  writeSequence(directory, original, kPart, kDisplay);
  const auto sequence = openSequence(directory.path());
  CHECK(sequence->width() == kPart.width);
  const FrameData frame = sequence->read(0);
  CHECK(frame.warnings.empty());
  CHECK(samePixels(frame.normalWorld, placed(original.normalWorld, kDisplay, kPart)));
  CHECK(frame.origin.windows.data == kPart);
  CHECK(frame.origin.windows.display == kDisplay);
  // A position shows at its pixel.
  const int x = 12, y = 17;
  const double w = multilayer::clipRow(frame.camera.worldToClip, 3, frame.positionWorld, x, y);
  const double column = multilayer::clipRow(frame.camera.worldToClip, 0, frame.positionWorld, x, y) / w;
  const double row = multilayer::clipRow(frame.camera.worldToClip, 1, frame.positionWorld, x, y) / w;
  CHECK(kPart.width * (0.5 + 0.5 * column) == Approx(x + 0.5).margin(0.01));
  CHECK(kPart.height * (0.5 - 0.5 * row) == Approx(y + 0.5).margin(0.01));
}

TEST_CASE("what a buffer does not cover is background, with a warning") {
  const TemporaryDirectory directory;
  const FrameData original = multilayer::builtIn()->read(0);
  writeSequence(directory, original, kDisplay, kPart);
  const FrameData frame = openSequence(directory.path())->read(0);
  REQUIRE(frame.warnings.size() == 2);
  CHECK(frame.warnings[0].kind == FrameWarning::Kind::Windows);
  CHECK_THAT(frame.warnings[0].file, Catch::Contains("shading_normal_0000.exr"));
  CHECK_THAT(frame.warnings[0].got, Catch::Contains("40x30 pixels from (7, 5) on"));
  for (int y = 0; y < kDisplay.height; ++y)
    for (int x = 0; x < kDisplay.width; ++x) {
      const bool inside = intersection({x, y, 1, 1}, kPart).width > 0;
      REQUIRE(frame.normalWorld.at(x, y, 1) == (inside ? original.normalWorld.at(x, y, 1) : 0.0f));
    }
}

TEST_CASE("windows that have nothing in common are refused by name") {
  const TemporaryDirectory directory;
  const FrameData original = multilayer::builtIn()->read(0);
  writeSequence(directory, original, {0, 0, 5, 5}, kPart);
  CHECK_THROWS_MATCHES(
      openSequence(directory.path())->read(0), Error,
      failsWith(ErrorCode::InvalidArgument,
                {"shading_normal_0000.exr", "5x5 pixels in a picture of", "40x30 pixels from (7, 5)"}));
  writeSequence(directory, original, kDisplay, kDisplay);
  writeCropped(directory.file("shading_normal_0000.exr"), original.normalWorld, {kPart, kPart});
  CHECK_THROWS_MATCHES(openSequence(directory.path())->read(0), Error,
                       failsWith(ErrorCode::InvalidArgument, {"shading_normal_0000.exr", "61x40 pixels"}));
}

TEST_CASE("the data window of a later frame is that of the first") {
  const TemporaryDirectory directory;
  for (const int number : {1, 2}) {
    const FrameData frame = multilayer::builtIn()->read(number);
    Planes planes;
    addPlanes(planes, "a.Combined", frame.radiance, "RGB");
    addPlanes(planes, "a.Normal", frame.normalWorld, "XYZ");
    addPlanes(planes, "a.Position", frame.positionWorld, "XYZ");
    addPlanes(planes, "a.Depth", multilayer::depthOf(frame), "Z");
    PictureWindows windows{kDisplay, kDisplay};
    if (number == 2) windows.data.x = 1;
    writePlanes(directory.file("000" + std::to_string(number) + ".exr"), planes, windows);
  }
  const auto sequence = openSequence(directory.path());
  CHECK_NOTHROW(sequence->read(1));
  CHECK_THROWS_MATCHES(sequence->read(2), Error,
                       failsWith(ErrorCode::InvalidArgument, {"0002.exr", "from (1, 0) on"}));
}
