// Every family of frames with faults against its bounds, for every method.
#include <catch2/catch.hpp>

#include "host/stress/frame_suite.hpp"
#include "tests/stress/test_fitter.hpp"

namespace quell::stress {

TEST_CASE("all methods keep the bounds of every family of frames") {
  const FitterOptions device = testOptions();
  FrameSuite suite(device.device, device.options);
  for (const FrameFamily& family : frameFamilies()) {
    const FrameRuns runs = makeFrameRuns(family, 20);
    for (const std::string& method : frameMethods()) {
      const FrameFigures figures = suite.run(family, runs, method);
      INFO(family.name << ", " << method << ": " << figures.nonFinite
                       << " frames not finite, outside the range " << figures.outsideRange
                       << ", difference at most " << figures.peak << ", at the end " << figures.left);
      CHECK(withinBounds(figures, family));
      CHECK(figures.peak > 0.0);
    }
  }
}

TEST_CASE("a method that does not keep the bounds of a family of frames is found out") {
  const FrameFamily gone{"", Trace::Gone, false, false, nullptr};
  const FrameFamily fading{"", Trace::Fading, false, false, nullptr};
  CHECK(withinBounds({0, 0.4, 1.0, 0.01}, gone));
  CHECK_FALSE(withinBounds({1, 0.4, 1.0, 0.01}, gone));
  CHECK_FALSE(withinBounds({0, 0.6, 1.0, 0.01}, gone));
  CHECK_FALSE(withinBounds({0, 0.4, 1.0, 0.05}, gone));
  CHECK(withinBounds({0, 0.4, 1.0, 0.3}, fading));
  CHECK_FALSE(withinBounds({0, 0.4, 1.0, 0.6}, fading));
}

}  // namespace quell::stress
