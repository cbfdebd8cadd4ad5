#include "host/io/cycles_sequence.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using quell::Error;
using quell::ErrorCode;
using quell::tests::failsWith;
using quell::tests::noiseImage;
using quell::tests::samePixels;
using quell::tests::TemporaryDirectory;

namespace {

constexpr int kWidth = 6, kHeight = 4;

std::string cameraEntry(int frame, const std::string& more = "") {
  return "{\"frame\": " + std::to_string(frame) +
         ", \"view_projection\": [[1,2,3,4],[5,6,7,8],[9,10,11,12],[13,14,15,16]],"
         " \"previous_view_projection\": [[0.1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]" +
         more + "}";
}

/// Frames 3 to 5 with the required buffers and albedo.
struct SmallSequence {
  TemporaryDirectory directory;

  SmallSequence() {
    for (int frame : {3, 4, 5})
      for (const char* buffer : {"color", "shading_normal", "world_position", "albedo"}) add(buffer, frame);
    writeCamera("{\"frames\": [" + cameraEntry(3) + "," + cameraEntry(5) + "," + cameraEntry(4) + "]}");
  }

  std::string fileOf(const char* buffer, int frame) const {
    return directory.file(std::string(buffer) + "_000" + std::to_string(frame) + ".exr");
  }
  void add(const char* buffer, int frame, int width = kWidth) const {
    writeExr(fileOf(buffer, frame), noiseImage(width, kHeight, 3, unsigned(frame)), ExrType::Float);
  }
  void remove(const char* buffer, int frame) const { std::filesystem::remove(fileOf(buffer, frame)); }
  void writeCamera(const std::string& text) const { writeTextFile(directory.file("camera.json"), text); }
};

}  // namespace

TEST_CASE("a Cycles sequence is read frame by frame") {
  const SmallSequence files;
  const auto sequence = openSequence(files.directory.path());
  REQUIRE(sequence->frames() == std::vector<int>{3, 4, 5});
  REQUIRE(sequence->width() == kWidth);
  REQUIRE(sequence->height() == kHeight);
  REQUIRE_FALSE(sequence->historyLimits().has_value());
  const FrameData frame = sequence->read(4);
  REQUIRE(frame.number == 4);
  REQUIRE_FALSE(frame.demodulated);
  const Image expected = noiseImage(kWidth, kHeight, 3, 4);
  REQUIRE(samePixels(frame.radiance, expected));
  REQUIRE(samePixels(frame.normalWorld, expected));
  REQUIRE(samePixels(frame.positionWorld, expected));
  REQUIRE(samePixels(frame.albedo, expected));
  REQUIRE(frame.glossColor.empty());
  REQUIRE(frame.emission.empty());
  for (std::size_t i = 0; i < 16; ++i) REQUIRE(frame.camera.worldToClip[i] == double(i + 1));
  REQUIRE(frame.camera.worldToClipPrev[0] == 0.1);
  REQUIRE(frame.camera.jitterPx == std::array<double, 2>{0.0, 0.0});
}

TEST_CASE("jitter of a frame is read where camera.json has it") {
  const SmallSequence files;
  REQUIRE_FALSE(openSequence(files.directory.path())->jittered());
  const auto writeJitter = [&](const std::string& value) {
    files.writeCamera("{\"frames\": [" + cameraEntry(3) + "," + cameraEntry(4, ", \"jitter_px\": " + value) +
                      "," + cameraEntry(5) + "]}");
  };
  writeJitter("[0.25, -1]");
  const auto sequence = openSequence(files.directory.path());
  REQUIRE(sequence->jittered());
  REQUIRE(sequence->read(4).camera.jitterPx == std::array<double, 2>{0.25, -1.0});
  REQUIRE(sequence->read(5).camera.jitterPx == std::array<double, 2>{0.0, 0.0});
  for (const char* value : {"[0.25]", "[0, 0, 0]", "\"no\"", "[0, null]", "0.5", "[0, 1.25]", "[-2, 0]"}) {
    INFO(value);
    writeJitter(value);
    REQUIRE_THROWS_MATCHES(CyclesSequence(files.directory.path()), Error,
                           failsWith(ErrorCode::FileError, {"camera.json"}));
  }
  writeJitter("[0, 1.25]");
  REQUIRE_THROWS_MATCHES(CyclesSequence(files.directory.path()), Error,
                         failsWith(ErrorCode::FileError, {"jitter_px of frame 4", "1.25"}));
}

TEST_CASE("references are optional, and so is their second half") {
  const SmallSequence files;
  files.add("ref_a_color", 4);
  files.add("ref_a_color", 5);
  files.add("ref_b_color", 5);
  const CyclesSequence sequence(files.directory.path());
  constexpr ReferenceKind kCentre = ReferenceKind::Centre;
  REQUIRE_FALSE(sequence.hasReference(3, kCentre));
  REQUIRE_THROWS_MATCHES(sequence.reference(3, kCentre), Error,
                         failsWith(ErrorCode::InvalidArgument, {"reference, centre", "3"}));
  REQUIRE_FALSE(sequence.hasReference(4, ReferenceKind::Antialiased));
  REQUIRE(sequence.reference(4, kCentre).b.empty());
  REQUIRE(samePixels(sequence.reference(5, kCentre).b, noiseImage(kWidth, kHeight, 3, 5)));
}

TEST_CASE("output is compared with pixel centres, that of jittered rays with the antialiased reference") {
  const SmallSequence files;
  const auto kindsOf = [&](int frame) {
    const CyclesSequence sequence(files.directory.path());
    References references(sequence);
    const auto& reference = references.of(frame);
    REQUIRE(reference.has_value() == references.has(frame));
    return std::string(reference ? toString(reference->kind) : "none");
  };
  const auto jitter = [&] {
    files.writeCamera("{\"frames\": [" + cameraEntry(3) + "," + cameraEntry(4, ", \"jitter_px\": [0.5, 0]") +
                      "," + cameraEntry(5) + "]}");
  };
  REQUIRE(kindsOf(4) == "none");
  files.add("ref_aa_a_color", 4);
  files.add("ref_aa_a_color", 5);
  REQUIRE(kindsOf(4) == "antialiased");
  files.add("ref_a_color", 5);
  REQUIRE(kindsOf(5) == "centre");
  REQUIRE(kindsOf(4) == "none");  // one kind for a whole sequence, or figures could not be averaged
  jitter();
  REQUIRE(kindsOf(5) == "antialiased");
  REQUIRE(kindsOf(4) == "antialiased");
  files.remove("ref_aa_a_color", 5);
  files.remove("ref_aa_a_color", 4);
  REQUIRE(kindsOf(5) == "centre");
}

TEST_CASE("a gap in the frames is named") {
  const SmallSequence files;
  files.remove("color", 4);
  REQUIRE_THROWS_MATCHES(CyclesSequence(files.directory.path()), Error,
                         failsWith(ErrorCode::FileError, {"color_0004.exr", "no frame 4"}));
}

TEST_CASE("a missing buffer is named, an absent optional one is not missed") {
  const SmallSequence files;
  SECTION("required") {
    files.remove("world_position", 5);
    REQUIRE_THROWS_MATCHES(CyclesSequence(files.directory.path()), Error,
                           failsWith(ErrorCode::FileError, {"world_position_0005.exr"}));
  }
  SECTION("optional, in some frames only") {
    files.remove("albedo", 3);
    REQUIRE_THROWS_MATCHES(CyclesSequence(files.directory.path()), Error,
                           failsWith(ErrorCode::FileError, {"albedo_0003.exr"}));
  }
  SECTION("optional, in no frame") {
    for (int frame : {3, 4, 5}) files.remove("albedo", frame);
    REQUIRE(CyclesSequence(files.directory.path()).read(3).albedo.empty());
  }
}

TEST_CASE("a size that differs from the first frame's is refused when read") {
  const SmallSequence files;
  files.add("albedo", 5, kWidth + 1);
  const CyclesSequence sequence(files.directory.path());
  REQUIRE_NOTHROW(sequence.read(4));
  REQUIRE_THROWS_MATCHES(sequence.read(5), Error,
                         failsWith(ErrorCode::InvalidArgument, {"albedo_0005.exr", "6x4", "7x4"}));
}

TEST_CASE("a camera file that lacks something is refused") {
  const SmallSequence files;
  const auto refusal = [&](const std::string& text, std::vector<std::string> words) {
    files.writeCamera(text);
    words.push_back("camera.json");
    REQUIRE_THROWS_MATCHES(CyclesSequence(files.directory.path()), Error,
                           failsWith(ErrorCode::FileError, words));
  };
  refusal("{\"frames\": [" + cameraEntry(3) + "," + cameraEntry(5) + "]}", {"frame 4"});
  refusal("{\"frames\": [{\"frame\": 3}]}", {"view_projection"});
  refusal("{\"frames\": [{\"frame\": 3, \"view_projection\": [[1,2,3],[1],[2],[3]]}]}", {"4 numbers"});
  refusal("{\"frames\": [{\"frame\": 3, \"view_projection\": [1, 2]}]}", {"4 rows"});
  refusal("{\"frames\": 7", {"parse error"});
  refusal("", {"parse error"});
}

TEST_CASE("frames that are not there and directories of another kind are refused") {
  const SmallSequence files;
  const auto sequence = openSequence(files.directory.path());
  REQUIRE_THROWS_MATCHES(sequence->read(6), Error,
                         failsWith(ErrorCode::InvalidArgument, {"from 3 to 5", "got 6"}));
  REQUIRE_THROWS_MATCHES(openSequence(files.directory.file("none")), Error,
                         failsWith(ErrorCode::FileError, {"no such directory"}));
  const TemporaryDirectory empty;
  REQUIRE_THROWS_MATCHES(
      openSequence(empty.path()), Error,
      failsWith(ErrorCode::FileError, {"camera.json", "camera_matrices.h", "no numbered OpenEXR files"}));
  writeTextFile(empty.file("camera.json"), "{\"frames\": []}");
  REQUIRE_THROWS_MATCHES(openSequence(empty.path()), Error,
                         failsWith(ErrorCode::FileError, {"color_0000.exr", "none"}));
}

TEST_CASE("motion vectors and object ids are read where every frame has them") {
  const SmallSequence files;
  REQUIRE(openSequence(files.directory.path())->read(4).motion.empty());
  REQUIRE(openSequence(files.directory.path())->read(4).objectId.empty());
  for (int frame : {3, 4, 5}) {
    writeExr(files.fileOf("motion", frame), noiseImage(kWidth, kHeight, 2, 50), ExrType::Float);
    writeExr(files.fileOf("object_id", frame), Image(kWidth, kHeight, 1, 70000.0f), ExrType::Uint);
  }
  const FrameData frame = openSequence(files.directory.path())->read(4);
  REQUIRE(samePixels(frame.motion, noiseImage(kWidth, kHeight, 2, 50)));
  REQUIRE(samePixels(frame.objectId, Image(kWidth, kHeight, 1, 70000.0f)));
  writeExr(files.fileOf("object_id", 4), noiseImage(kWidth, kHeight, 3, 50));
  REQUIRE_THROWS_MATCHES(openSequence(files.directory.path())->read(4), Error,
                         failsWith(ErrorCode::FileError, {"object_id_0004.exr", "channels Y"}));
  files.remove("motion", 3);
  REQUIRE_THROWS_MATCHES(openSequence(files.directory.path()), Error,
                         failsWith(ErrorCode::FileError, {"motion_0003.exr"}));
}

TEST_CASE("two signals are read beside the picture as a whole") {
  const SmallSequence files;
  const Image glossy = noiseImage(kWidth, kHeight, 3, 40, 1.0f, 2.0f);  // they explain all of the light
  for (int frame : {3, 4, 5}) {
    writeExr(files.fileOf("diffuse_irradiance", frame), noiseImage(kWidth, kHeight, 3, 30), ExrType::Float);
    writeExr(files.fileOf("glossy_radiance", frame), glossy, ExrType::Float);
  }
  const FrameData whole = openSequence(files.directory.path())->read(4);
  REQUIRE(whole.glossyRadiance.empty());
  REQUIRE(whole.combined.empty());
  REQUIRE_FALSE(whole.demodulated);
  REQUIRE(samePixels(whole.noisy(), whole.radiance));
  const FrameData frame = openSequence(files.directory.path(), 2)->read(4);
  REQUIRE(frame.demodulated);
  REQUIRE(samePixels(frame.combined, whole.radiance));
  REQUIRE(samePixels(frame.radiance, noiseImage(kWidth, kHeight, 3, 30)));
  REQUIRE(samePixels(frame.glossyRadiance, glossy));
  REQUIRE(samePixels(frame.noisy(), frame.combined));
  REQUIRE(frame.comparable());
}

TEST_CASE("two signals need both of their buffers in every frame") {
  const SmallSequence files;
  for (int frame : {3, 4, 5}) files.add("diffuse_irradiance", frame);
  for (int frame : {3, 4}) files.add("glossy_radiance", frame);
  REQUIRE_THROWS_MATCHES(openSequence(files.directory.path(), 2), Error,
                         failsWith(ErrorCode::FileError, {"glossy_radiance_0005.exr"}));
  files.add("glossy_radiance", 5);
  REQUIRE_NOTHROW(openSequence(files.directory.path(), 2));
  files.remove("diffuse_irradiance", 3);
  REQUIRE_THROWS_MATCHES(openSequence(files.directory.path(), 2), Error,
                         failsWith(ErrorCode::FileError, {"diffuse_irradiance_0003.exr"}));
}
