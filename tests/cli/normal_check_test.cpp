#include "host/cli/watch/normal_check.hpp"

#include <catch2/catch.hpp>
#include <functional>

#include "host/analytic/sequence.hpp"
#include "host/io/frame_sequence.hpp"
#include "tests/support/tool.hpp"

using namespace quell;
using namespace quell::cli;
using quell::io::FrameData;
using Kind = quell::io::FrameWarning::Kind;

namespace {

// Room with sky above.
FrameData room() {
  io::AnalyticOptions options;
  options.width = 96;
  options.height = 54;
  options.skyShare = 0.2;
  return io::makeAnalyticSequence(options)->read(0);
}

// The same with other components of normals.
FrameData with(const std::function<float(float)>& change) {
  FrameData frame = room();
  for (float& component : frame.normalWorld.pixels) component = change(component);
  return frame;
}

}  // namespace

TEST_CASE("normals in order, of whatever length, give no warning") {
  CHECK_FALSE(checkNormals(room(), "file").has_value());
  for (const float length : {0.5f, 2.0f, 1e-3f, 100.0f})
    CHECK_FALSE(checkNormals(with([&](float n) { return length * n; }), "file").has_value());
  const auto colonnade = io::openSequence(tests::kData);
  CHECK_FALSE(checkNormals(colonnade->read(4), "file").has_value());
  // A corner of which all normals point along the axes.
  FrameData corner = room();
  for (std::size_t i = 0; i < corner.normalWorld.pixels.size(); ++i)
    corner.normalWorld.pixels[i] = i % 3 == (i / 30) % 3 ? 1.0f : 0.0f;
  CHECK_FALSE(checkNormals(corner, "file").has_value());
}

TEST_CASE("normals packed to 0..1 are told, with the background packed or not") {
  const auto all = checkNormals(with([](float n) { return 0.5f * n + 0.5f; }), "normals.exr");
  REQUIRE(all.has_value());
  CHECK(all->kind == Kind::PackedNormals);
  CHECK(all->file == "normals.exr");
  CHECK_THAT(all->remedy, Catch::Contains("2 n - 1"));
  FrameData frame = room();
  for (std::size_t i = 0; i < frame.normalWorld.pixels.size(); i += 3) {
    float* n = &frame.normalWorld.pixels[i];
    const bool background = n[0] == 0.0f && n[1] == 0.0f && n[2] == 0.0f;
    for (int axis = 0; axis < 3 && !background; ++axis) n[axis] = 0.5f * n[axis] + 0.5f;
  }
  CHECK(checkNormals(frame, "file")->kind == Kind::PackedNormals);
}

TEST_CASE("normals of length 0 are told where light falls on surfaces, not in the sky") {
  FrameData frame = room();
  for (int y = 40; y < 44; ++y)
    for (int x = 40; x < 44; ++x)
      for (int axis = 0; axis < 3; ++axis) frame.normalWorld.at(x, y, axis) = 0.0f;
  const auto warning = checkNormals(frame, "file");
  REQUIRE(warning.has_value());
  CHECK(warning->kind == Kind::MissingNormals);
  CHECK_THAT(warning->got, Catch::Contains("0.3 %"));
  frame.albedo = {};
  CHECK(checkNormals(frame, "file").has_value());
}
