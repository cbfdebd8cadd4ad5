// The sequence that ships with the repository is what data/README.md says.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "host/io/frame_sequence.hpp"
#include "tests/support/further_sequences.hpp"

using namespace quell::io;
using quell::tests::furtherSequences;

namespace {

/// How far a position may project from where its pixel was sampled: 0.014 px were measured when the frames were
/// rendered.
constexpr double kMaxOffSamplePx = 0.02;

constexpr double kMaxNormalLengthError = 0.002;  // unit length to 0.001, then stored in half

bool isBackground(const FrameData& frame, int x, int y) {
  return frame.normalWorld.at(x, y, 0) == 0.0f && frame.normalWorld.at(x, y, 1) == 0.0f &&
         frame.normalWorld.at(x, y, 2) == 0.0f;
}

/// Distance between where the primary ray went and where its position projects, in pixels.
double offSamplePx(const FrameData& frame, int x, int y) {
  const Image& position = frame.positionWorld;
  const auto clip = [&](std::size_t r) {
    const double* row = &frame.camera.worldToClip[4 * r];
    return row[0] * double(position.at(x, y, 0)) + row[1] * double(position.at(x, y, 1)) +
           row[2] * double(position.at(x, y, 2)) + row[3];
  };
  const double column = (0.5 + 0.5 * clip(0) / clip(3)) * position.width;
  const double row = (0.5 - 0.5 * clip(1) / clip(3)) * position.height;
  return std::hypot(column - (x + 0.5 + frame.camera.jitterPx[0]),
                    row - (y + 0.5 + frame.camera.jitterPx[1]));
}

double normalLength(const FrameData& frame, int x, int y) {
  return std::hypot(double(frame.normalWorld.at(x, y, 0)), double(frame.normalWorld.at(x, y, 1)),
                    double(frame.normalWorld.at(x, y, 2)));
}

void checkGeometry(const FrameData& frame) {
  const int width = frame.positionWorld.width, height = frame.positionWorld.height;
  double worstOffSamplePx = 0.0, worstLengthError = 0.0;
  int surfaces = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (isBackground(frame, x, y)) continue;
      ++surfaces;
      worstOffSamplePx = std::max(worstOffSamplePx, offSamplePx(frame, x, y));
      worstLengthError = std::max(worstLengthError, std::abs(normalLength(frame, x, y) - 1.0));
    }
  CHECK(surfaces > width * height / 2);
  CHECK(worstOffSamplePx < kMaxOffSamplePx);
  CHECK(worstLengthError < kMaxNormalLengthError);
}

}  // namespace

TEST_CASE("positions of the shipped sequence project to where pixels are sampled") {
  const auto sequence = openSequence(std::string(QUELL_DATA_DIR) + "/colonnade");
  REQUIRE(sequence->width() == 240);
  REQUIRE(sequence->height() == 135);
  for (int number : sequence->frames()) {
    INFO("frame " << number);
    checkGeometry(sequence->read(number));
  }
}

TEST_CASE("positions of further sequences project to where pixels are sampled", "[.sequences]") {
  for (const std::string& directory : furtherSequences("camera.json")) {
    const auto sequence = openSequence(directory);
    INFO(sequence->name());
    checkGeometry(sequence->read(sequence->frames().front()));
    checkGeometry(sequence->read(sequence->frames().back()));
  }
}

TEST_CASE("the shipped sequence is complete") {
  const auto sequence = openSequence(std::string(QUELL_DATA_DIR) + "/colonnade");
  REQUIRE(sequence->frames().front() == 4);
  REQUIRE(sequence->frames().back() == 15);
  const FrameData first = sequence->read(4), second = sequence->read(5);
  REQUIRE_FALSE(first.albedo.empty());
  REQUIRE_FALSE(first.glossColor.empty());
  REQUIRE_FALSE(first.emission.empty());
  for (std::size_t i = 0; i < 16; ++i)
    REQUIRE(second.camera.worldToClipPrev[i] == Approx(first.camera.worldToClip[i]).margin(1e-6));
  REQUIRE_FALSE(sequence->reference(15, ReferenceKind::Centre).b.empty());
}
