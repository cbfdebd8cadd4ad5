// Files with the channel names of each renderer are read as the same frames as our own layout.
#include "tests/support/renderer_files.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/frame_sequence.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using namespace quell::tests;
using quell::Error;
using quell::ErrorCode;

namespace {

std::string cameraText(int frame, const quell::Matrix4& m) {
  std::string text = "[";
  for (std::size_t i = 0; i < 16; ++i)
    text += (i % 4 == 0 ? (i > 0 ? "],[" : "[") : ",") + std::to_string(m[i]);
  text += "]]";
  return "{\"frames\": [{\"frame\": " + std::to_string(frame) + ", \"view_projection\": " + text +
         ", \"previous_view_projection\": " + text + "}]}";
}

void writeOwn(const std::string& directory, const FrameData& frame) {
  const auto write = [&](const std::string& stem, const Image& image) {
    writeExr(directory + "/" + stem + "_0001.exr", image, ExrType::Float);
  };
  write("color", frame.radiance);
  write("shading_normal", frame.normalWorld);
  write("world_position", frame.positionWorld);
  write("albedo", frame.albedo);
  write("emission", frame.emission);
  writeTextFile(directory + "/camera.json", cameraText(1, frame.camera.worldToClip));
}

SequenceOptions withChannels(const std::vector<std::string>& channels) {
  SequenceOptions options;
  options.channels.channels = channels;
  return options;
}

}  // namespace

TEST_CASE("each renderer's names give the frame of our own layout") {
  const TemporaryDirectory own;
  const FrameData original = multilayer::builtIn()->read(1);
  writeOwn(own.path(), original);
  const FrameData expected = openSequence(own.path())->read(1);
  for (const RendererFiles& files : rendererFiles()) {
    INFO(files.renderer);
    const TemporaryDirectory directory;
    files.write(directory.path(), original);
    if (!files.hasCamera)
      writeTextFile(directory.file("camera.json"), cameraText(1, original.camera.worldToClip));
    const auto sequence = openSequence(directory.path());
    REQUIRE(sequence->frames() == std::vector<int>{1});
    const FrameData frame = sequence->read(1);
    CHECK(frame.warnings.empty());
    CHECK(samePixels(frame.radiance, expected.radiance));
    CHECK(samePixels(frame.normalWorld, expected.normalWorld));
    CHECK(samePixels(frame.positionWorld, expected.positionWorld));
    CHECK(samePixels(frame.albedo, expected.albedo));
    CHECK(samePixels(frame.emission, files.hasEmission ? expected.emission : Image()));
    CHECK(multilayer::projectionError(frame.camera.worldToClip, expected.camera.worldToClip, expected) <
          1e-3);
    CHECK_THAT(sequence->describeChannels().front(), Catch::Contains(files.renderer));
    const std::vector<std::string> lines = sequence->describeChannels();
    const bool missing = std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
      return line.find("emission     not there") != std::string::npos;
    });
    CHECK(missing != files.hasEmission);
  }
}

TEST_CASE("numbers may stand before the names of passes") {
  const FrameData original = multilayer::builtIn()->read(1);
  const TemporaryDirectory directory;
  renderers::luxcore(directory.path(), original);
  writeTextFile(directory.file("camera.json"), cameraText(1, original.camera.worldToClip));
  for (const char* pass : {"RGB", "ALBEDO", "AVG_SHADING_NORMAL", "POSITION", "DEPTH", "EMISSION"})
    std::filesystem::rename(directory.file(pass + std::string("_0001.exr")),
                            directory.file("shot_0001_" + std::string(pass) + ".exr"));
  const auto sequence = openSequence(directory.path());
  CHECK_THAT(sequence->describeChannels().front(), Catch::Contains("luxcore, layer shot"));
  const FrameData frame = sequence->read(1);
  CHECK(samePixels(frame.radiance, original.radiance));
  CHECK(samePixels(frame.emission, original.emission));
}

TEST_CASE("passes may lie in folders of their own") {
  const FrameData original = multilayer::builtIn()->read(1);
  const TemporaryDirectory directory;
  const auto write = [&](const std::string& pass, const Image& image) {
    std::filesystem::create_directory(directory.file(pass));
    writeExr(directory.file(pass) + "/0001.exr", image, ExrType::Float);
  };
  write("Image", original.radiance);
  write("Normal", original.normalWorld);
  write("Position", original.positionWorld);
  write("Diffuse Color", original.albedo);
  writeExr(directory.file("Image") + "/ref_a_0001.exr", original.albedo, ExrType::Float);
  writeTextFile(directory.file("camera.json"), cameraText(1, original.camera.worldToClip));
  const auto sequence = openSequence(directory.path());
  const FrameData frame = sequence->read(1);
  CHECK(frame.warnings.empty());
  CHECK(samePixels(frame.radiance, original.radiance));
  CHECK(samePixels(frame.albedo, original.albedo));
  CHECK(samePixels(sequence->reference(1, ReferenceKind::Centre).a, original.albedo));
}

TEST_CASE("any names do with --channels, in one file or a file for each pass") {
  const FrameData original = multilayer::builtIn()->read(1);
  const TemporaryDirectory one, several;
  Planes planes;
  addPlanes(planes, "", original.positionWorld, "RGB");
  addPlanes(planes, "light.a", original.radiance, "XYZ");
  for (const auto& [letter, name] : {std::pair{'X', "nx"}, {'Y', "ny"}, {'Z', "nz"}}) {
    Planes normal;
    addPlanes(normal, "", original.normalWorld, "XYZ");
    planes[name] = normal[std::string(1, letter)];
  }
  writePlanes(one.file("7.exr"), planes);
  for (const auto& [name, plane] : planes) writePlanes(several.file(name + "_7.exr"), {{"v", plane}});
  for (const TemporaryDirectory* directory : {&one, &several})
    writeTextFile(directory->file("camera.json"), cameraText(7, original.camera.worldToClip));
  const auto check = [&](const std::string& path, const std::vector<std::string>& channels) {
    const FrameData frame = openSequence(path, withChannels(channels))->read(7);
    CHECK(samePixels(frame.radiance, original.radiance));
    CHECK(samePixels(frame.normalWorld, original.normalWorld));
    CHECK(samePixels(frame.positionWorld, original.positionWorld));
  };
  check(one.path(), {"color=light.a", "normal=nx,ny,nz", "position=R,G,B"});
  check(several.path(),
        {"color=light.a.X.v,light.a.Y.v,light.a.Z.v", "normal=nx.v,ny.v,nz.v", "position=R.v,G.v,B.v"});
}

TEST_CASE("what cannot be found says what was looked for, and what there is") {
  const TemporaryDirectory directory;
  Planes planes;
  addPlanes(planes, "", noiseImage(4, 4, 3, 1), "RGB");
  addPlanes(planes, "extra", noiseImage(4, 4, 3, 1), "RGB");
  writePlanes(directory.file("1.exr"), planes);
  CHECK_THROWS_MATCHES(
      openSequence(directory.path()), Error,
      failsWith(ErrorCode::FileError, {"channels of normal", "--channels normal=", "RGB, extra.RGB"}));
  CHECK_THROWS_MATCHES(openSequence(directory.path(), withChannels({"normal=extra", "position=P"})), Error,
                       failsWith(ErrorCode::FileError, {"channels of position (P)"}));
  CHECK_THROWS_MATCHES(
      openSequence(directory.path(), withChannels({"normal=extra", "position=extra", "albedo=Kd"})), Error,
      failsWith(ErrorCode::FileError, {"channels of albedo (Kd)", "RGB, extra.RGB"}));
  for (const char* wrong : {"normal", "normals=N", "normal=X,Y", "normal=", "normal=a+", "depth=Z:far"})
    CHECK_THROWS_MATCHES(openSequence(directory.path(), withChannels({wrong})), Error,
                         failsWith(ErrorCode::InvalidArgument));
}
