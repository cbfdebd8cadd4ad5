// Motion vectors of other conventions.
#include <catch2/catch.hpp>

#include "host/check/view.hpp"
#include "host/io/motion_kind.hpp"
#include "tests/check/plane_frames.hpp"
#include "tests/support/check_kinds.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

constexpr Size kSize{kPlaneWidth, kPlaneHeight};

// As the matrices say, times a factor.
io::FrameData moving(int number, float factorX, float factorY) {
  io::FrameData frame = planeFrame(number);
  frame.motion = io::Image(kPlaneWidth, kPlaneHeight, 2);
  for (int y = 0; y < kPlaneHeight; ++y)
    for (int x = 0; x < kPlaneWidth; ++x) {
      const glm::dvec3 p(frame.positionWorld.at(x, y, 0), frame.positionWorld.at(x, y, 1),
                         frame.positionWorld.at(x, y, 2));
      const auto then = check::project(frame.camera.worldToClipPrev, p, kSize);
      const auto here = check::project(frame.camera.worldToClip, p, kSize);
      frame.motion.at(x, y, 0) = factorX * float(then->x - here->x);
      frame.motion.at(x, y, 1) = factorY * float(then->y - here->y);
    }
  return frame;
}

check::Result resultOf(float factorX, float factorY) {
  return checked(moving(2, factorX, factorY), moving(3, factorX, factorY));
}

std::string gotOf(const check::Result& result) {
  return result.findings.empty() ? std::string() : result.findings[0].finding.got;
}

}  // namespace

TEST_CASE("motion in pixels from this frame to the one before is in order", "[check]") {
  CHECK(kindsOf(resultOf(1.0f, 1.0f)) == "");
}

TEST_CASE("motion of another sign, unit or scale is named", "[check]") {
  const float w = kPlaneWidth, h = kPlaneHeight;
  const auto told = [](float x, float y, const char* is) {
    const check::Result result = resultOf(x, y);
    INFO(is);
    CHECK(kindsOf(result, Severity::Doubtful).find("motion-convention ") == 0);
    CHECK_THAT(gotOf(result), Catch::Contains(is));
    // The kind that the cure names for files makes it right.
    const std::string cure = result.findings[0].finding.cure, before = "--channels motion=NAME:";
    const std::size_t at = cure.find(before);
    if (at == std::string::npos) return;
    const std::string kind =
        cure.substr(at + before.size(), cure.find(' ', at + before.size()) - at - before.size());
    io::FrameData then = moving(2, x, y), now = moving(3, x, y);
    for (io::FrameData* frame : {&then, &now})
      io::toContract(frame->motion, io::parseMotionKind(kind), kPlaneWidth, kPlaneHeight);
    CHECK(kindsOf(checked(then, now)) == "");
  };
  told(-1.0f, -1.0f, "current minus previous");
  told(1.0f / w, 1.0f / h, "shares of the image");
  told(-1.0f / w, 1.0f / h, "current minus previous, y up, as shares of the image");
  told(2.0f / w, -2.0f / h, "y up, in NDC");
  told(3.0f, 3.0f, "3.000 times as long");
}

TEST_CASE("vectors that leave the camera out are named", "[check]") {
  CHECK(kindsOf(resultOf(0.0f, 0.0f), Severity::Doubtful).find("motion-zero ") == 0);
}

TEST_CASE("objects that move need numbers of their own", "[check]") {
  io::FrameData before = moving(2, 1.0f, 1.0f), now = moving(3, 1.0f, 1.0f);
  before.objectId = now.objectId = io::Image(kPlaneWidth, kPlaneHeight, 1);
  CHECK(kindsOf(checked(before, now)) == "");
  for (int y = 30; y < 60; ++y)
    for (int x = 60; x < 90; ++x) now.motion.at(x, y, 0) += 5.0f;
  CHECK(kindsOf(checked(before, now)) == "object-ids-alike ");
  for (int y = 30; y < 60; ++y)
    for (int x = 60; x < 90; ++x) now.objectId.at(x, y, 0) = 7.0f;
  CHECK(kindsOf(checked(before, now)) == "");
}

TEST_CASE("history that is nowhere to be found is told", "[check]") {
  io::FrameData before = planeFrame(2), now = planeFrame(3);
  for (std::size_t i = 2; i < before.positionWorld.pixels.size(); i += 3)
    before.positionWorld.pixels[i] = 3.0f;
  CHECK(kindsOf(checked(before, now), Severity::Doubtful) == "history-lost ");
}
