#include "host/io/multilayer_sequence.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "host/analytic/sequence.hpp"
#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/multilayer_camera.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/multilayer_files.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using quell::Error;
using quell::ErrorCode;
using quell::Matrix4;
using quell::tests::failsWith;
using quell::tests::noiseImage;
using quell::tests::samePixels;
using quell::tests::TemporaryDirectory;
using namespace quell::tests::multilayer;

namespace {

std::string matrixText(const Matrix4& m) {
  std::string text = "[";
  for (std::size_t row = 0; row < 4; ++row) {
    text += row > 0 ? ",[" : "[";
    for (std::size_t column = 0; column < 4; ++column)
      text += (column > 0 ? "," : "") + std::to_string(m[4 * row + column]);
    text += "]";
  }
  return text + "]";
}

}  // namespace

TEST_CASE("a multilayer file is read as a sequence of one frame, with the camera that it shows") {
  const TemporaryDirectory directory;
  const FrameData original = builtIn()->read(3);
  Passes passes = passesOf(original);
  passes["GlossCol"] = noiseImage(kWidth, kHeight, 3, 1);
  passes["IndexOB"] = Image(kWidth, kHeight, 1, 5.0f);
  passes["Vector"] = noiseImage(kWidth, kHeight, 4, 2);
  passes["Env"] = Image(kWidth, kHeight, 3, 0.25f);
  writeMultilayer(directory.file("shot_0012.exr"), passes);
  const auto sequence = openSequence(directory.file("shot_0012.exr"));
  REQUIRE(sequence->frames() == std::vector<int>{12});
  REQUIRE(sequence->width() == kWidth);
  REQUIRE(sequence->height() == kHeight);
  REQUIRE_FALSE(sequence->hasReference(12, ReferenceKind::Centre));
  const FrameData frame = sequence->read(12);
  REQUIRE(frame.number == 12);
  REQUIRE_FALSE(frame.demodulated);
  REQUIRE(samePixels(frame.radiance, original.radiance));
  REQUIRE(samePixels(frame.normalWorld, original.normalWorld));
  REQUIRE(samePixels(frame.positionWorld, original.positionWorld));
  REQUIRE(samePixels(frame.albedo, original.albedo));
  REQUIRE(samePixels(frame.glossColor, passes["GlossCol"]));
  REQUIRE(samePixels(frame.objectId, passes["IndexOB"]));
  REQUIRE(frame.emission.at(7, 9, 1) == original.emission.at(7, 9, 1) + 0.25f);
  REQUIRE(projectionError(frame.camera.worldToClip, original.camera.worldToClip, original) < 1e-3);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (isSky(original, x, y)) {
        REQUIRE(std::isnan(frame.motion.at(x, y, 1)));
      } else {
        REQUIRE(frame.motion.at(x, y, 0) == passes["Vector"].at(x, y, 0));
        REQUIRE(frame.motion.at(x, y, 1) == -passes["Vector"].at(x, y, 1));
      }
    }
  }
}

TEST_CASE("a directory of multilayer files has the camera of the frame before, too") {
  const TemporaryDirectory directory;
  const auto original = builtIn();
  for (const int number : {1, 2}) {
    writeMultilayer(directory.file("000" + std::to_string(number) + ".exr"),
                    passesOf(original->read(number)));
  }
  const auto sequence = openSequence(directory.path());
  REQUIRE(sequence->frames() == std::vector<int>{1, 2});
  const FrameData expected = original->read(2), frame = sequence->read(2);
  REQUIRE(projectionError(frame.camera.worldToClip, expected.camera.worldToClip, expected) < 1e-3);
  REQUIRE(projectionError(frame.camera.worldToClipPrev, expected.camera.worldToClipPrev, expected) < 1e-3);
  REQUIRE_THROWS_MATCHES(sequence->read(3), Error, failsWith(ErrorCode::InvalidArgument, {"1 to 2"}));
  writeMultilayer(directory.file("0004.exr"), passesOf(original->read(4)));
  REQUIRE_THROWS_MATCHES(openSequence(directory.path()), Error,
                         failsWith(ErrorCode::FileError, {"0003.exr", "without gaps"}));
}

TEST_CASE("diffuse and glossy passes are two signals") {
  const TemporaryDirectory directory;
  Passes passes = passesOf(builtIn()->read(0));
  for (const char* pass : {"DiffDir", "DiffInd", "GlossDir", "GlossInd", "GlossCol"})
    passes[pass] = noiseImage(kWidth, kHeight, 3, unsigned(passes.size()));
  writeMultilayer(directory.file("0.exr"), passes);
  const FrameData frame = openSequence(directory.path(), 2)->read(0);
  REQUIRE(frame.demodulated);
  REQUIRE(samePixels(frame.combined, passes["Combined"]));
  REQUIRE(frame.radiance.at(3, 5, 2) == passes["DiffDir"].at(3, 5, 2) + passes["DiffInd"].at(3, 5, 2));
  REQUIRE(frame.glossyRadiance.at(3, 5, 2) ==
          passes["GlossDir"].at(3, 5, 2) + passes["GlossInd"].at(3, 5, 2));
  passes.erase("GlossInd");
  writeMultilayer(directory.file("0.exr"), passes);
  REQUIRE_NOTHROW(openSequence(directory.path()));
  REQUIRE_THROWS_MATCHES(openSequence(directory.path(), 2), Error,
                         failsWith(ErrorCode::FileError, {"View Layer.GlossInd"}));
}

TEST_CASE("depth and a camera.json stand in for positions") {
  const TemporaryDirectory directory;
  const FrameData original = builtIn()->read(3);
  Passes passes = passesOf(original);
  passes.erase("Position");
  writeMultilayer(directory.file("0003.exr"), passes);
  REQUIRE_THROWS_MATCHES(
      openSequence(directory.path()), Error,
      failsWith(ErrorCode::FileError, {"View Layer.Position", "camera.json", "View Layer.DiffCol.RGB"}));
  const std::string matrix = matrixText(original.camera.worldToClip);
  writeTextFile(directory.file("camera.json"), "{\"frames\": [{\"frame\": 3, \"view_projection\": " + matrix +
                                                   ", \"previous_view_projection\": " + matrix + "}]}");
  const FrameData frame = openSequence(directory.path())->read(3);
  double worst = 0.0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int axis = 0; axis < 3 && !isSky(original, x, y); ++axis)
        worst = std::max(worst, std::abs(double(frame.positionWorld.at(x, y, axis)) -
                                         original.positionWorld.at(x, y, axis)));
  REQUIRE(worst < 1e-3);
}

TEST_CASE("passes and layers that are missing are named") {
  const TemporaryDirectory directory;
  const Passes all = passesOf(builtIn()->read(0));
  const std::string path = directory.file("0007.exr");
  const auto openWithout = [&](const char* pass) {
    Passes passes = all;
    passes.erase(pass);
    writeMultilayer(path, passes);
    return openSequence(path);
  };
  REQUIRE_THROWS_MATCHES(openWithout("Normal"), Error,
                         failsWith(ErrorCode::FileError, {"0007.exr", "View Layer.Normal"}));
  REQUIRE_THROWS_MATCHES(openWithout("Combined"), Error,
                         failsWith(ErrorCode::FileError, {"channels of color", "--channels color="}));
  for (const char* pass : {"Depth", "DiffCol", "Emit", "Env"}) REQUIRE_NOTHROW(openWithout(pass)->read(7));

  Imf::Header header(kWidth, kHeight);
  Imf::FrameBuffer buffer;
  addPasses("Front", all, header, buffer);
  addPasses("Back", all, header, buffer);
  {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(kHeight);
  }
  REQUIRE_THROWS_MATCHES(openSequence(path), Error,
                         failsWith(ErrorCode::FileError, {"one view layer", "--layer", "Back, Front"}));
  SequenceOptions options;
  options.channels.layer = "Front";
  REQUIRE(samePixels(openSequence(path, options)->read(7).radiance, all.at("Combined")));
  options.channels.layer = "Middle";
  REQUIRE_THROWS_MATCHES(openSequence(path, options), Error,
                         failsWith(ErrorCode::FileError, {"view layer Middle", "Back, Front"}));
}

TEST_CASE("a frame from which no camera follows goes on with the last one, and says so") {
  const TemporaryDirectory directory;
  const auto original = builtIn();
  for (int number = 1; number <= 5; ++number) {
    Passes passes = passesOf(original->read(number));
    if (number == 1 || number == 3) passes["Depth"] = Image(kWidth, kHeight, 1, 1e10f);  // sky alone
    writeMultilayer(directory.file("000" + std::to_string(number) + ".exr"), passes);
  }
  const auto sequence = openSequence(directory.path());
  const auto cameraOf = [&](int frame) { return sequence->read(frame).camera.worldToClip; };
  CHECK(cameraOf(3) == cameraOf(2));
  CHECK(sequence->read(4).camera.worldToClipPrev == cameraOf(2));
  CHECK(cameraOf(4) != cameraOf(2));
  for (const int frame : {2, 4, 5}) CHECK(sequence->read(frame).warnings.empty());
  const std::string file[] = {"0001.exr", "0003.exr"}, done[] = {"one made up", "that of frame 2"};
  for (const int i : {0, 1}) {
    const auto warnings = sequence->read(2 * i + 1).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].kind == FrameWarning::Kind::Camera);
    CHECK_THAT(warnings[0].file, Catch::Contains(file[i]));
    CHECK_THAT(warnings[0].got, Catch::Contains("no surfaces"));
    CHECK_THAT(warnings[0].remedy, Catch::Contains(done[i]) && Catch::Contains("camera.json"));
  }
}

TEST_CASE("references lie beside multilayer files, whole or as colours") {
  const TemporaryDirectory directory;
  Passes passes = passesOf(builtIn()->read(0));
  for (const char* name : {"shot_0000.exr", "shot_0001.exr"}) writeMultilayer(directory.file(name), passes);
  passes["Combined"] = noiseImage(kWidth, kHeight, 3, 5);
  writeMultilayer(directory.file("ref_a_shot_0001.exr"), passes);
  writeExr(directory.file("ref_b_color_0001.exr"), noiseImage(kWidth, kHeight, 3, 6), ExrType::Float);
  for (const std::string& path : {directory.path(), directory.file("shot_####.exr")}) {
    const auto sequence = openSequence(path);
    CHECK(sequence->frames() == std::vector<int>{0, 1});
    CHECK_FALSE(sequence->hasReference(0, ReferenceKind::Centre));
    CHECK_FALSE(sequence->hasReference(1, ReferenceKind::Antialiased));
    CHECK_FALSE(sequence->hasReference(2, ReferenceKind::Centre));
    REQUIRE(sequence->hasReference(1, ReferenceKind::Centre));
    const Reference reference = sequence->reference(1, ReferenceKind::Centre);
    CHECK(samePixels(reference.a, passes["Combined"]));
    CHECK(samePixels(reference.b, noiseImage(kWidth, kHeight, 3, 6)));
  }
}

TEST_CASE("motion is turned to that of the contract") {
  const TemporaryDirectory directory;
  Passes passes = passesOf(builtIn()->read(0));
  const Image vectors = noiseImage(kWidth, kHeight, 4, 7);
  passes["Vector"] = vectors;
  writeMultilayer(directory.file("0.exr"), passes);
  const auto motionAs = [&](const char* channels) {
    SequenceOptions options;
    if (*channels != '\0') options.channels.channels = {channels};
    return openSequence(directory.path(), options)->read(0).motion.at(9, 30, 1);
  };
  const float y = vectors.at(9, 30, 1);
  CHECK(motionAs("") == -y);  // Blender's points up
  CHECK(motionAs("motion=View Layer.Vector") == y);
  CHECK(motionAs("motion=View Layer.Vector:uv/from-previous") == -y * kHeight);
}

TEST_CASE("alpha of Combined is kept") {
  const TemporaryDirectory directory;
  Passes passes = passesOf(builtIn()->read(0));
  writeMultilayer(directory.file("0.exr"), passes);
  CHECK(openSequence(directory.path())->read(0).alpha.empty());
  const Image rgba = noiseImage(kWidth, kHeight, 4, 3);
  passes["Combined"] = rgba;
  writeMultilayer(directory.file("0.exr"), passes);
  const FrameData frame = openSequence(directory.path())->read(0);
  REQUIRE(frame.alpha.channels == 1);
  CHECK(frame.alpha.at(7, 9, 0) == rgba.at(7, 9, 3));
  CHECK(frame.radiance.channels == 3);
  CHECK(frame.radiance.at(7, 9, 2) == rgba.at(7, 9, 2));
}
