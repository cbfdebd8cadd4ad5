#include "host/cli/watch/noise_watch.hpp"

#include <catch2/catch.hpp>
#include <memory>

#include "host/analytic/sequence.hpp"
#include "host/io/frame_sequence.hpp"
#include "tests/support/tool.hpp"

using namespace quell;
using namespace quell::cli;
using quell::io::FrameData;

namespace {

std::unique_ptr<io::FrameSequence> room(bool movingCamera) {
  io::AnalyticOptions options;
  options.width = 160;
  options.height = 90;
  options.movingCamera = movingCamera;
  return io::makeAnalyticSequence(options);
}

FrameData numbered(FrameData frame, int number) {
  frame.number = number;
  return frame;
}

// Without noise: light that changes smoothly over the picture.
FrameData withoutNoise(FrameData frame) {
  for (int y = 0; y < frame.radiance.height; ++y)
    for (int x = 0; x < frame.radiance.width; ++x)
      for (int c = 0; c < 3; ++c)
        frame.radiance.at(x, y, c) =
            frame.emission.at(x, y, c) + frame.albedo.at(x, y, c) * float(1 + 0.01 * x);
  return frame;
}

NoiseWatch::Result after(const FrameData& first, const FrameData& second) {
  NoiseWatch watch;
  watch.add(first);
  return watch.add(second);
}

}  // namespace

TEST_CASE("noise of its own in every frame is no cause for alarm") {
  for (const bool moving : {false, true}) {
    const auto sequence = room(moving);
    NoiseWatch watch;
    for (int number = 0; number < 5; ++number) {
      const NoiseWatch::Result result = watch.add(sequence->read(number));
      CHECK_FALSE(result.frozen);
      CHECK_FALSE(result.repeats);
      CHECK(result.correlation < 0.2);
    }
  }
  const auto colonnade = io::openSequence(tests::kData);
  CHECK_FALSE(after(colonnade->read(4), colonnade->read(5)).frozen);
}

TEST_CASE("noise that stays the same is found, and frames that repeat it at the same place") {
  const FrameData still = room(false)->read(0);
  const NoiseWatch::Result result = after(still, numbered(still, 1));
  CHECK(result.frozen);
  CHECK(result.repeats);
  CHECK(result.correlation > 0.99);
  // Under a camera that moves history has the noise of other pixels.
  const FrameData moving = room(true)->read(0);
  CHECK(after(moving, numbered(moving, 1)).frozen);
  CHECK_FALSE(after(moving, numbered(moving, 1)).repeats);
}

TEST_CASE("frames in a row are compared, and only where noise can be told from texture") {
  const FrameData frame = room(false)->read(0);
  CHECK_FALSE(after(frame, numbered(frame, 2)).frozen);
  CHECK_FALSE(after(withoutNoise(frame), numbered(withoutNoise(frame), 1)).frozen);
  FrameData withoutAlbedo = frame;
  withoutAlbedo.albedo = {};
  CHECK_FALSE(after(withoutAlbedo, numbered(withoutAlbedo, 1)).frozen);
}
