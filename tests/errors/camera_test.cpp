// Cameras that cannot be used.
#include <limits>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

// Parallel projection along -z of a square with an edge of 2 scene units.
constexpr Matrix4 kOrthographic = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};

// The same view from somewhere else.
Matrix4 movedBy(const Matrix4& m, double dx) {
  Matrix4 moved = m;
  for (const std::size_t row : {0, 1, 2, 3}) moved[4 * row + 3] -= m[4 * row] * dx;
  return moved;
}

Refusal invalid(const std::string& buffer, const std::string& expected, const std::string& got,
                const std::string& stage = "camera") {
  return {ErrorCode::InvalidArgument, stage, buffer, expected, got};
}

// Refused on the second frame, when both cameras count.
void checkCamera(const Refusal& refusal, void (*spoil)(Camera&)) {
  SmallDenoiser small;
  small.run(0);
  const Frame good = small.buffers.frame;
  spoil(small.buffers.frame.camera);
  checkRefused(refusal, [&] { small.enqueue(); });
  small.buffers.frame = good;
  CHECK_NOTHROW(small.enqueue().wait());
  checkStillWorks(small);
}

}  // namespace

TEST_CASE("matrices that are not finite are refused by name", "[errors]") {
  checkCamera(invalid("worldToClip", "finite", "[0][1]"), [](Camera& c) { c.worldToClip[1] = kNan; });
  checkCamera(invalid("worldToClipPrev", "finite", "[3][3]"),
              [](Camera& c) { c.worldToClipPrev[15] = std::numeric_limits<double>::infinity(); });
}

TEST_CASE("singular matrices are refused by name", "[errors]") {
  checkCamera(invalid("worldToClip", "independent", "singular"), [](Camera& c) {
    for (std::size_t i = 0; i < 4; ++i) c.worldToClip[i] = c.worldToClip[4 + i];
  });
  // All zero stands for the camera of the frame before.
  checkCamera(invalid("worldToClipPrev", "clip.w > 0", "0"), [](Camera& c) { c.worldToClipPrev = {1.0}; });
}

TEST_CASE("jitter beyond a pixel is refused by name", "[errors]") {
  checkCamera(invalid("jitterPx", "[-1, 1]", "1.5"), [](Camera& c) { c.jitterPx[0] = 1.5; });
  checkCamera(invalid("jitterPx", "[-1, 1]", "nan"), [](Camera& c) { c.jitterPx[1] = kNan; });
}

TEST_CASE("the camera before may be anything on the first frame", "[errors]") {
  SmallDenoiser small;
  const Picture expected = small.run(0);
  small.denoiser.resetHistory();
  small.buffers.upload(0);
  small.buffers.frame.camera.worldToClipPrev.fill(kNan);
  CHECK_NOTHROW(small.enqueue().wait());
  CHECK(small.buffers.download() == expected);
}

TEST_CASE("half positions are refused far from the origin", "[errors]") {
  ImageSetup setup;
  setup.positionWorld = packedHalf(3);
  SmallDenoiser small(setup);
  small.run(0);
  const Frame good = small.buffers.frame;
  small.buffers.frame.camera.worldToClip = movedBy(good.camera.worldToClip, 100.0);
  checkRefused({ErrorCode::OutOfRange, "denoise", "positionWorld", "within 32", "a camera coordinate of"},
               [&] { small.enqueue(); });
  small.buffers.frame = good;
  CHECK_NOTHROW(small.enqueue().wait());
}

TEST_CASE("view depth and an orthographic camera exclude each other", "[errors]") {
  ImageSetup setup;
  setup.positionWorld = absent();
  setup.viewDepth = packed(1);
  SmallDenoiser small(setup);
  Frame frame = small.buffers.frame;
  frame.camera.worldToClip = kOrthographic;
  checkRefused(invalid("viewDepth", "a perspective camera", "orthographic", "denoise"),
               [&] { small.denoiser.denoise(frame, small.buffers.output); });
  CHECK_NOTHROW(small.enqueue().wait());
  checkRefused(invalid("viewDepth", "a perspective camera", "orthographic", "prepare"),
               [&] { small.denoiser.prepare(frame, small.buffers.output); });
  frame.camera.worldToClip = {};  // not known yet
  CHECK_NOTHROW(small.denoiser.prepare(frame, small.buffers.output));
  CHECK_NOTHROW(small.enqueue().wait());
}

TEST_CASE("an orthographic camera works with positions", "[errors]") {
  SmallDenoiser small;
  small.buffers.frame.camera.worldToClip = small.buffers.frame.camera.worldToClipPrev = kOrthographic;
  for (int i = 0; i < 2; ++i) CHECK_NOTHROW(small.enqueue().wait());
  for (const float value : small.buffers.download().display.pixels) REQUIRE((value >= 0.0f && value <= 1.0f));
}

}  // namespace quell::tests
