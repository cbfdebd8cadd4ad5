#include "host/io/bmfr_sequence.hpp"

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

constexpr int kWidth = 12, kHeight = 10;
constexpr double kOffset0[2] = {0.5, 0.5}, kOffset2[2] = {0.25, 0.125};

/// m[column][row] of frame 0 and 1, y down; any invertible numbers do.
constexpr double kMatrix0[4][4] = {
    {0.9, 0.1, 0.0, 0.2}, {-0.2, 1.1, 0.1, 0.3}, {0.3, 0.2, 1.0, 1.0}, {0.4, -0.5, 0.6, 4.0}};
constexpr double kMatrix1[4][4] = {
    {0.8, 0.2, 0.0, 0.1}, {-0.1, 1.2, 0.1, 0.2}, {0.2, 0.1, 1.0, 1.1}, {0.3, -0.4, 0.5, 5.0}};

const char kCameraHeader[] = R"(#ifndef CAMERA_MATRICES_H
#define CAMERA_MATRICES_H
// limits of the data set
const float position_limit_squared = 0.01f; /* scene units */
#define normal_limit_squared 0.1f
const float camera_matrices[3][4][4] = {
  {{0.9f, 0.1f, 0.0f, 0.2f}, {-0.2f, 1.1f, 0.1f, 0.3f}, {0.3f, 0.2f, 1.0f, 1.0f}, {0.4f, -0.5f, 0.6f, 4.0f}},
  {{0.8f, 0.2f, 0.0f, 0.1f}, {-0.1f, 1.2f, 0.1f, 0.2f}, {0.2f, 0.1f, 1.0f, 1.1f}, {0.3f, -0.4f, 0.5f, 5.0f}},
  {{1.0f, 0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}},
};
const float pixel_offsets[3][2] = { {0.5f, 0.5f}, {0.75f, 0.5f}, {0.25f, 0.125f} };
#endif
)";

struct SmallSequence {
  TemporaryDirectory directory;

  SmallSequence() {
    for (int frame : {0, 1, 2})
      for (const char* buffer : {"color", "shading_normal", "world_position", "albedo"}) add(buffer, frame);
    writeHeader(kCameraHeader);
  }

  std::string fileOf(const char* buffer, int frame) const {
    return directory.file(buffer + std::to_string(frame) + ".exr");
  }
  void add(const char* buffer, int frame, int width = kWidth) const {
    writeExr(fileOf(buffer, frame), noiseImage(width, kHeight, 3, unsigned(frame)), ExrType::Float);
  }
  void writeHeader(const std::string& text) const {
    writeTextFile(directory.file("camera_matrices.h"), text);
  }
};

struct Pixel {
  double column, row;
};

/// As the published host code finds the previous pixel: y points down, the row's offset counts from below.
Pixel previousPixelAsPublished(const double (&m)[4][4], const double (&offset)[2], const double (&p)[3]) {
  const auto clip = [&](int r) { return m[0][r] * p[0] + m[1][r] * p[1] + m[2][r] * p[2] + m[3][r]; };
  return {(clip(0) / clip(3) + 1.0) / 2.0 * kWidth - offset[0],
          (clip(1) / clip(3) + 1.0) / 2.0 * kHeight - (1.0 - offset[1])};
}

/// As quell::Camera defines it.
Pixel previousPixelOfCamera(const quell::Camera& camera, const double (&p)[3]) {
  const auto clip = [&](std::size_t r) {
    const double* row = &camera.worldToClipPrev[4 * r];
    return row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
  };
  return {(0.5 + 0.5 * clip(0) / clip(3)) * kWidth - 0.5 - camera.jitterPx[0],
          (0.5 - 0.5 * clip(1) / clip(3)) * kHeight - 0.5 - camera.jitterPx[1]};
}

void requireSamePixel(const Pixel& a, const Pixel& b) {
  REQUIRE(a.column == Approx(b.column).epsilon(1e-12));
  REQUIRE(a.row == Approx(b.row).epsilon(1e-12));
}

}  // namespace

TEST_CASE("a BMFR sequence is read frame by frame") {
  const SmallSequence files;
  const auto sequence = openSequence(files.directory.path());
  REQUIRE(sequence->frames() == std::vector<int>{0, 1, 2});
  REQUIRE(sequence->width() == kWidth);
  REQUIRE(sequence->height() == kHeight);
  REQUIRE(sequence->historyLimits()->positionSquared == 0.01);
  REQUIRE(sequence->historyLimits()->normalSquared == 0.1);
  const FrameData frame = sequence->read(2);
  REQUIRE(frame.demodulated);
  REQUIRE(samePixels(frame.radiance, noiseImage(kWidth, kHeight, 3, 2)));
  REQUIRE(samePixels(frame.albedo, noiseImage(kWidth, kHeight, 3, 2)));
  REQUIRE(frame.emission.empty());
  REQUIRE_FALSE(sequence->hasReference(2, ReferenceKind::Antialiased));
}

TEST_CASE("reprojection finds the pixel that the published code finds") {
  const SmallSequence files;
  const BmfrSequence sequence(files.directory.path());
  constexpr double kPoints[][3] = {{0.3, -0.7, 1.9}, {-2.0, 1.0, 0.5}};
  for (const auto& point : kPoints) {
    requireSamePixel(previousPixelOfCamera(sequence.read(0).camera, point),
                     previousPixelAsPublished(kMatrix0, kOffset0, point));
    requireSamePixel(previousPixelOfCamera(sequence.read(2).camera, point),
                     previousPixelAsPublished(kMatrix1, kOffset2, point));
  }
  REQUIRE(sequence.read(1).camera.worldToClip == sequence.read(2).camera.worldToClipPrev);
  REQUIRE(sequence.jittered());
  REQUIRE_FALSE(isJittered(sequence.read(0).camera));
}

TEST_CASE("pixel offsets that leave the pixel and its neighbours are refused") {
  const SmallSequence files;
  std::string header = kCameraHeader;
  header.replace(header.find("0.75f, 0.5f"), 11, "1.75f, 0.5f");
  files.writeHeader(header);
  REQUIRE_THROWS_MATCHES(BmfrSequence(files.directory.path()), Error,
                         failsWith(ErrorCode::FileError, {"pixel_offsets of frame 1", "1.25"}));
}

TEST_CASE("a single reference file is the whole reference") {
  const SmallSequence files;
  files.add("reference", 1);
  const BmfrSequence sequence(files.directory.path());
  const Reference reference =
      sequence.reference(1, ReferenceKind::Antialiased);  // pixel offsets are jittered
  REQUIRE(samePixels(reference.a, noiseImage(kWidth, kHeight, 3, 1)));
  REQUIRE(reference.b.empty());
  REQUIRE_FALSE(sequence.hasReference(1, ReferenceKind::Centre));
}

TEST_CASE("limits are optional but come in pairs") {
  const SmallSequence files;
  const std::string arrays =
      std::string(kCameraHeader).substr(std::string(kCameraHeader).find("const float cam"));
  files.writeHeader(arrays);
  REQUIRE_FALSE(BmfrSequence(files.directory.path()).historyLimits().has_value());
  files.writeHeader("#define normal_limit_squared 0.1f\n" + arrays);
  REQUIRE_THROWS_MATCHES(BmfrSequence(files.directory.path()), Error,
                         failsWith(ErrorCode::FileError, {"position_limit_squared", "or neither"}));
}

TEST_CASE("a camera header that lacks something is refused") {
  const SmallSequence files;
  const auto refusal = [&](const std::string& text, const std::string& words) {
    files.writeHeader(text);
    REQUIRE_THROWS_MATCHES(BmfrSequence(files.directory.path()), Error,
                           failsWith(ErrorCode::FileError, {"camera_matrices.h", words}));
  };
  refusal("", "camera_matrices");
  refusal("float camera_matrices[1][4][4] = {1, 2, 3};", "16 numbers per frame");
  refusal("float camera_matrices[1][4][4] = {1,2,3,4, 1,2,3,4, 1,2,3,4, 1,2,3,4};", "frames 0 to 2");
  files.add("color", 3);
  for (const char* buffer : {"shading_normal", "world_position", "albedo"}) files.add(buffer, 3);
  refusal(kCameraHeader, "frames 0 to 3");
}

TEST_CASE("missing frames and other sizes are named in this layout too") {
  const SmallSequence files;
  SECTION("gap") {
    std::filesystem::remove(files.fileOf("color", 1));
    REQUIRE_THROWS_MATCHES(BmfrSequence(files.directory.path()), Error,
                           failsWith(ErrorCode::FileError, {"color1.exr", "no frame 1"}));
  }
  SECTION("buffer") {
    std::filesystem::remove(files.fileOf("albedo", 1));
    REQUIRE_THROWS_MATCHES(BmfrSequence(files.directory.path()), Error,
                           failsWith(ErrorCode::FileError, {"albedo1.exr"}));
  }
  SECTION("size") {
    files.add("world_position", 1, 5);
    REQUIRE_THROWS_MATCHES(BmfrSequence(files.directory.path()).read(1), Error,
                           failsWith(ErrorCode::InvalidArgument, {"world_position1.exr", "12x10", "5x10"}));
  }
}

TEST_CASE("this layout has no two signals") {
  const SmallSequence files;
  REQUIRE_THROWS_MATCHES(
      openSequence(files.directory.path(), 2), Error,
      failsWith(ErrorCode::FileError, {"two signals", "camera.json", "camera_matrices.h", "one"}));
}
