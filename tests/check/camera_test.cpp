// Cameras that do not fit positions.
#include <catch2/catch.hpp>
#include <cmath>

#include "host/analytic/sequence.hpp"
#include "host/check/projection.hpp"
#include "host/check/view.hpp"
#include "host/cli/common/command_arguments.hpp"
#include "tests/check/plane_frames.hpp"
#include "tests/support/check_kinds.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

std::unique_ptr<io::FrameSequence> room(bool jitter) {
  io::AnalyticOptions options;
  options.width = 64;
  options.height = 36;
  options.frameCount = 3;
  options.jitter = jitter;
  return io::makeAnalyticSequence(options);
}

std::string doubts(const io::FrameData& frame) { return kindsOf(checked(frame), Severity::Doubtful); }

void scalePositions(io::FrameData& frame, float x, float y, float z) {
  for (std::size_t i = 0; i < frame.positionWorld.pixels.size(); ++i)
    frame.positionWorld.pixels[i] *= i % 3 == 0 ? x : i % 3 == 1 ? y : z;
}

// Every image one row lower.
void moveDown(io::FrameData& frame) {
  for (const auto& facts : kInputs<io::FrameData>) {
    io::Image& image = frame.*facts.member;
    for (int y = image.height - 1; y > 0; --y)
      for (int x = 0; x < image.width; ++x)
        for (int c = 0; c < image.channels; ++c) image.at(x, y, c) = image.at(x, y - 1, c);
  }
}

}  // namespace

TEST_CASE("rays through pixel centres have no offset, nor those whose jitter the camera says", "[check]") {
  for (const bool jitter : {false, true}) {
    const auto sequence = room(jitter);
    CHECK(check::rayOffsetPx(cli::viewOf(sequence->read(1))) < 0.02);
    CHECK(sequence->jittered() == jitter);
    CHECK(cli::defaultSettings("quell", *sequence).get("jitteredRays") == (jitter ? 1.0 : 0.0));
  }
}

TEST_CASE("jitter that nothing but positions show is noticed, and jitter of the wrong sign", "[check]") {
  io::FrameData frame = room(true)->read(1);
  const auto jitter = frame.camera.jitterPx;
  REQUIRE(jitter != std::array<double, 2>{0.0, 0.0});
  frame.camera.jitterPx = {-jitter[0], -jitter[1]};
  const check::Result result = checked(frame);
  REQUIRE(kindsOf(result, Severity::Doubtful) == "image-shifted ");
  CHECK_THAT(result.findings[0].finding.cure, Catch::Contains("negate jitterPx"));
  frame.camera.jitterPx = {0.0, 0.0};
  CHECK(check::rayOffsetPx(cli::viewOf(frame)) == Approx(std::hypot(jitter[0], jitter[1])).margin(0.02));
  frame.positionWorld = io::Image();
  CHECK(check::rayOffsetPx(cli::viewOf(frame)) == 0.0);
}

TEST_CASE("rays anywhere in their pixels are a note", "[check]") {
  io::FrameData frame = room(false)->read(0);
  const check::View view = *check::viewOf(frame.camera.worldToClip);
  for (int y = 0; y < 36; ++y)
    for (int x = 0; x < 64; ++x) {
      const glm::dvec3 p(frame.positionWorld.at(x, y, 0), frame.positionWorld.at(x, y, 1),
                         frame.positionWorld.at(x, y, 2));
      const double depth = check::clipOf(frame.camera.worldToClip, 3, p) / view.depthUnit;
      const double u = std::fmod(0.754877 * (x + 64 * y), 1.0), v = std::fmod(0.569840 * (x + 64 * y), 1.0);
      const glm::dvec3 moved =
          depth * (check::rayThrough(frame.camera.worldToClip, view, {x + u, y + v}, {64, 36}) -
                   check::rayThrough(frame.camera.worldToClip, view, {x + 0.5, y + 0.5}, {64, 36}));
      if (p != glm::dvec3(0.0))
        for (int axis = 0; axis < 3; ++axis) frame.positionWorld.at(x, y, axis) += float(moved[axis]);
    }
  CHECK(kindsOf(checked(frame)).find("features-jittered") != std::string::npos);
  CHECK(doubts(frame) == "");
}

TEST_CASE("matrices of another convention are named", "[check]") {
  const io::FrameData right = planeFrame(3);
  const auto with = [&](const Matrix4& matrix) {
    io::FrameData frame = right;
    frame.camera.worldToClip = matrix;
    return doubts(frame);
  };
  const Matrix4& m = right.camera.worldToClip;
  CHECK(with(*check::inverse(m)) == "camera-inverse ");
  CHECK(with(*check::inverse(check::transposed(m))) == "camera-inverse-transposed ");
  CHECK(with(check::scaledRows(m, {-1, 1, 1, 1})) == "image-flipped-x ");
  CHECK(with(check::scaledRows(m, {-1, -1, 1, 1})) == "image-rotated ");
  CHECK(with(check::scaledRows(m, {-1, -1, -1, -1})) == "camera-negated ");
  CHECK(with(check::transposed(check::scaledRows(m, {1, -1, 1, 1}))) == "camera-transposed-flipped-y ");
  const double aspect = double(right.radiance.width) / right.radiance.height;
  REQUIRE(aspect != 1.0);
  CHECK(with(check::scaledRows(m, {aspect, aspect, 1, 1})) == "camera-fov-axis ");
  CHECK(with(check::scaledRows(m, {1 / aspect, 1 / aspect, 1, 1})) == "camera-fov-axis ");
  CHECK(with(planeFrame(40).camera.worldToClip) == "position-camera-mismatch ");
  CHECK(with(Matrix4{}) == "position-camera-mismatch ");
}

TEST_CASE("positions of another space or unit, and cameras that are swapped, are named", "[check]") {
  io::FrameData frame = planeFrame(3);
  std::swap(frame.camera.worldToClip, frame.camera.worldToClipPrev);
  CHECK(doubts(frame) == "camera-swapped ");
  frame = planeFrame(3);
  scalePositions(frame, 0.01f, 0.01f, 0.01f);
  CHECK(doubts(frame) == "position-unit ");
  frame = planeFrame(3);
  scalePositions(frame, 1.0f, -1.0f, 1.0f);
  CHECK(doubts(frame) == "position-axes ");
  frame = planeFrame(3);
  const glm::dvec3 eye = check::viewOf(frame.camera.worldToClip)->eye;
  for (std::size_t i = 0; i < frame.positionWorld.pixels.size(); ++i)
    frame.positionWorld.pixels[i] -= float(eye[int(i % 3)]);
  CHECK(doubts(frame) == "position-camera-relative ");
}

TEST_CASE("an image that lies one row off is told by how much", "[check]") {
  io::FrameData frame = planeFrame(0);
  moveDown(frame);
  const check::Result result = checked(frame);
  REQUIRE(kindsOf(result, Severity::Doubtful) == "image-shifted ");
  CHECK_THAT(result.findings[0].finding.got, Catch::Contains("-1.00 px below"));
}

TEST_CASE("the matrix of the frame before must be the one that it had", "[check]") {
  io::FrameData before = planeFrame(2), now = planeFrame(3);
  now.camera.worldToClipPrev = planeFrame(0).camera.worldToClip;
  CHECK(kindsOf(checked(before, now), Severity::Doubtful) == "previous-camera ");
  before.number = 1;  // not the frame before
  CHECK(kindsOf(checked(before, now), Severity::Doubtful) == "");
}

TEST_CASE("a matrix of the frame before that is this frame's is told though the camera hardly moves",
          "[check]") {
  io::FrameData before = planeFrame(3), now = planeFrame(3);
  before.number = 2;
  now.radiance = planeFrame(4).radiance;  // noise of its own
  Matrix4& m = before.camera.worldToClip;
  for (std::size_t i = 0; i < 4; ++i) m[i] += 0.2 * 2.0 / kPlaneWidth * m[12 + i];  // 0.2 pixels to the right
  now.camera.worldToClipPrev = m;
  CHECK(kindsOf(checked(before, now), Severity::Doubtful) == "");
  now.camera.worldToClipPrev = now.camera.worldToClip;
  CHECK(kindsOf(checked(before, now), Severity::Doubtful) == "previous-camera-frozen ");
}

TEST_CASE("a frame whose camera only stands in is not asked where it looks", "[check]") {
  io::FrameData frame = planeFrame(3);
  frame.camera.worldToClip = planeFrame(40).camera.worldToClip;
  frame.warnings.push_back({io::FrameWarning::Kind::Camera, "file", "a camera", "none", "give one"});
  CHECK(doubts(frame) == "");
}
