// Normals that are not as the contract says.
#include <catch2/catch.hpp>
#include <functional>
#include <glm/geometric.hpp>

#include "host/analytic/sequence.hpp"
#include "host/check/view.hpp"
#include "tests/support/check_kinds.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

// Room with sky above.
io::FrameData room() {
  io::AnalyticOptions options;
  options.width = 96;
  options.height = 54;
  options.skyShare = 0.2;
  return io::makeAnalyticSequence(options)->read(0);
}

using Change = std::function<glm::dvec3(const glm::dvec3&)>;

io::FrameData with(const Change& change, bool backgroundToo = false) {
  io::FrameData frame = room();
  for (std::size_t i = 0; i < frame.normalWorld.pixels.size(); i += 3) {
    float* n = &frame.normalWorld.pixels[i];
    const glm::dvec3 given(n[0], n[1], n[2]);
    if (given == glm::dvec3(0.0) && !backgroundToo) continue;
    const glm::dvec3 changed = change(given);
    for (int axis = 0; axis < 3; ++axis) n[axis] = float(changed[axis]);
  }
  return frame;
}

std::string doubts(const io::FrameData& frame) { return kindsOf(checked(frame), Severity::Doubtful); }

}  // namespace

TEST_CASE("normals of any length are in order, and a corner along the axes is not packed") {
  for (const double length : {0.5, 2.0, 1e-3, 100.0})
    CHECK(doubts(with([&](const glm::dvec3& n) { return length * n; })) == "");
  io::FrameData corner = room();
  for (std::size_t i = 0; i < corner.normalWorld.pixels.size(); ++i)
    corner.normalWorld.pixels[i] = i % 3 == (i / 30) % 3 ? 1.0f : 0.0f;
  CHECK(doubts(corner).find("normals-packed") == std::string::npos);
}

TEST_CASE("normals packed to 0..1 are told, with the background packed or not") {
  const auto pack = [](const glm::dvec3& n) { return 0.5 * n + 0.5; };
  for (const bool background : {false, true}) {
    const check::Result result = checked(with(pack, background));
    REQUIRE_FALSE(result.findings.empty());
    CHECK(result.findings[0].finding.kind == "normals-packed");
    CHECK_THAT(result.findings[0].finding.cure, Catch::Contains("2 n - 1"));
    CHECK(result.findings[0].finding.pixels > 1000);
  }
}

TEST_CASE("normals in view space, of other axes and turned away are told") {
  const auto view = check::viewOf(room().camera.worldToClip);
  REQUIRE(view.has_value());
  const auto inView = [&](const glm::dvec3& n) {
    return glm::dvec3(glm::dot(n, view->right), glm::dot(n, view->up), -glm::dot(n, view->forward));
  };
  CHECK(doubts(with(inView)) == "normals-view-space ");
  CHECK(doubts(with([](const glm::dvec3& n) { return glm::dvec3(n.x, n.z, -n.y); })) == "normals-axes ");
  CHECK(doubts(with([](const glm::dvec3& n) { return -n; })) == "normals-flipped ");
}

TEST_CASE("normals of length 0 are told where light falls on surfaces, not in the sky") {
  io::FrameData frame = room();
  for (int y = 40; y < 44; ++y)
    for (int x = 40; x < 44; ++x)
      for (int axis = 0; axis < 3; ++axis) frame.normalWorld.at(x, y, axis) = 0.0f;
  const check::Result result = checked(frame);
  CHECK(kindsOf(result, Severity::Doubtful) == "normals-missing ");
  CHECK(result.findings[0].finding.pixels == 16);
  CHECK_THAT(result.findings[0].finding.got, Catch::Contains("0.3 %"));
  // The picture shows them.
  const check::Map& map = result.findings[0].map;
  REQUIRE(map.width == 96);
  CHECK(map.values[41 * 96 + 41] == 1.0f);
  CHECK(map.values[39 * 96 + 41] == 0.0f);
  frame.albedo = {};
  CHECK(doubts(frame) == "normals-missing ");
}
