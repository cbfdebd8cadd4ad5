// Rays off their pixel centres are noticed by positions alone.
#include "host/cli/common/ray_jitter.hpp"

#include <catch2/catch.hpp>

#include "host/analytic/sequence.hpp"
#include "host/cli/common/command_arguments.hpp"

using namespace quell;

namespace {

std::unique_ptr<io::FrameSequence> analytic(bool jitter) {
  io::AnalyticOptions options;
  options.width = 64;
  options.height = 36;
  options.frameCount = 2;
  options.jitter = jitter;
  return io::makeAnalyticSequence(options);
}

}  // namespace

TEST_CASE("rays through pixel centres have no offset, nor those whose jitter the camera says", "[cli]") {
  for (const bool jitter : {false, true}) {
    const auto sequence = analytic(jitter);
    CHECK(cli::rayOffsetPx(sequence->read(1)) < 0.02);
    CHECK(sequence->jittered() == jitter);
    CHECK(cli::defaultSettings("quell", *sequence).get("jitteredRays") == (jitter ? 1.0 : 0.0));
  }
}

TEST_CASE("jitter that nothing but positions show is noticed", "[cli]") {
  io::FrameData frame = analytic(true)->read(1);
  REQUIRE(frame.camera.jitterPx != std::array<double, 2>{0.0, 0.0});
  const auto jitter = frame.camera.jitterPx;
  frame.camera.jitterPx = {0.0, 0.0};
  CHECK(cli::rayOffsetPx(frame) == Approx(std::hypot(jitter[0], jitter[1])).margin(0.02));
  frame.positionWorld = io::Image();
  CHECK(cli::rayOffsetPx(frame) == 0.0);
}
