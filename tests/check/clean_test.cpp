// Frames in order give no cause for doubt.
#include <catch2/catch.hpp>
#include <string>

#include "host/analytic/sequence.hpp"
#include "tests/check/plane_frames.hpp"
#include "tests/support/check_kinds.hpp"

namespace quell::tests {
namespace {

void requireClean(const io::FrameSequence& sequence, int first, int last) {
  io::FrameData before = sequence.read(first);
  CHECK(kindsOf(checked(before), Severity::Doubtful) == "");
  for (int number = first + 1; number <= last; ++number) {
    INFO(sequence.name() << ", frame " << number);
    io::FrameData now = sequence.read(number);
    CHECK(kindsOf(checked(before, now), Severity::Doubtful) == "");
    before = std::move(now);
  }
}

}  // namespace

TEST_CASE("the built-in sequence is clean, moving, still, jittered, under sky and far from the origin") {
  io::AnalyticOptions options;
  options.width = 128;
  options.height = 72;
  requireClean(*io::makeAnalyticSequence(options), 0, 2);
  options.movingCamera = false;
  requireClean(*io::makeAnalyticSequence(options), 0, 2);
  options.movingCamera = true;
  options.jitter = true;
  options.skyShare = 0.6;
  requireClean(*io::makeAnalyticSequence(options), 0, 2);
  options.worldOffset = {1000.0, -500.0, 20.0};
  requireClean(*io::makeAnalyticSequence(options), 1, 2);
}

TEST_CASE("rendered frames are clean") {
  const auto sequence = io::openSequence(std::string(QUELL_DATA_DIR) + "/colonnade");
  requireClean(*sequence, 4, 6);
  const check::Result result = checked(sequence->read(14), sequence->read(15));
  CHECK(kindsOf(result) == "");
}

TEST_CASE("frames without surfaces, and tiny ones, are no cause for guesses") {
  io::FrameData frame = planeFrame(0);
  for (io::Image* image : {&frame.normalWorld, &frame.positionWorld})
    std::fill(image->pixels.begin(), image->pixels.end(), 0.0f);
  CHECK(kindsOf(checked(frame)) == "no-surfaces ");
  io::AnalyticOptions options;
  options.width = 1;
  options.height = 1;
  CHECK(kindsOf(checked(io::makeAnalyticSequence(options)->read(0)), Severity::Wrong) == "");
}

TEST_CASE("what images are missing is said where it costs quality") {
  io::FrameData frame = planeFrame(0);
  frame.albedo = {};
  CHECK(kindsOf(checked(frame)) == "no-albedo ");
}

}  // namespace quell::tests
