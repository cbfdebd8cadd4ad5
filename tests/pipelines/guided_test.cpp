// The whole method guided: real data against references, constants, broken pixels, two signals.
#include <catch2/catch.hpp>

#include "tests/pipelines/colonnade.hpp"

namespace quell::tests {
namespace {

// Errors on data/colonnade, frame 15, measured on PoCL 3.1: with the defaults, and as published.
constexpr double kUnbiasedRmse = 0.0823;
constexpr double kSsim = 0.790;
constexpr double kPaperUnbiasedRmse = 0.1079;
// Regression takes sums of squares apart, so a constant comes back with four digits.
constexpr double kConstantError = 1e-3;

}  // namespace

TEST_CASE("guided denoises the sequence in data/ to its known errors", "[pipelines]") {
  Settings paper("guided"), fine("guided");
  paper.usePreset("paper");
  fine.set("subsampling", "1");
  const auto usual = errorsOnColonnade(Settings("guided"));
  const auto published = errorsOnColonnade(paper);
  const auto everyPixel = errorsOnColonnade(fine);
  INFO("unbiased RMSE " << *usual.at("unbiased_rmse") << ", SSIM " << *usual.at("ssim") << "; preset paper "
                        << *published.at("unbiased_rmse") << "; of every pixel "
                        << *everyPixel.at("unbiased_rmse"));
  // With 5 % of slack for other devices.
  CHECK(*usual.at("unbiased_rmse") < kUnbiasedRmse * 1.05);
  CHECK(*usual.at("ssim") > kSsim - 0.02);
  CHECK(*published.at("unbiased_rmse") < kPaperUnbiasedRmse * 1.05);
  // Cells lose little against pixels.
  CHECK(*usual.at("unbiased_rmse") < 1.1 * *everyPixel.at("unbiased_rmse"));
}

TEST_CASE("guided handles images of any size, and cells larger than they are", "[pipelines]") {
  for (const Size size : {Size{1, 1}, Size{7, 93}, Size{33, 31}}) {
    const auto sequence = analyticSequence(size.width, size.height, 3);
    for (const char* subsampling : {"1", "8"}) {
      INFO(size.width << "x" << size.height << ", cells of " << subsampling);
      Settings settings("guided");
      settings.set("subsampling", subsampling);
      checkClean(denoiseSequence(*sequence, firstFrames(3), settings));
      checkClean(denoiseSequence(*sequence, firstFrames(3), settings, {}, addGloss));
    }
  }
}

TEST_CASE("guided leaves constant light as it is", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 3);
  const auto light = [](io::FrameData& frame) {
    for (std::size_t i = 0; i < frame.radiance.pixels.size(); ++i)
      frame.radiance.pixels[i] = 2.0f * frame.albedo.pixels[i] + frame.emission.pixels[i];
  };
  const auto result = denoiseSequence(*sequence, firstFrames(3), Settings("guided"), {}, light);
  for (int i = 0; i < 3; ++i) {
    io::FrameData frame = sequence->read(i);
    light(frame);
    CHECK(largestError(result.frames[std::size_t(i)].linear, frame.radiance) < kConstantError);
  }
}

TEST_CASE("broken pixels reach neither outputs nor history of guided", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 12);
  const auto poison = [](int poisons) {
    return [poisons](io::FrameData& frame) { breakPixels(frame, poisons); };
  };
  const Settings settings("guided");
  checkClean(denoiseSequence(*sequence, firstFrames(4), settings, {}, poison(kPoisons)));
  const auto broken =
      denoiseSequence(*sequence, firstFrames(12), settings, {}, poison(kPoisonsWithoutFireflies));
  const auto whole = denoiseSequence(*sequence, firstFrames(12), settings);
  checkClean(broken);
  // Nine frames after the last fault next to nothing is left of it.
  CHECK(encodedRmse(broken.frames.back().linear, whole.frames.back().linear) < 0.01);
}

TEST_CASE("guided gives the same picture with one pixel a work-item as with sixteen, bit for bit again",
          "[pipelines]") {
  const auto sequence = analyticSequence(70, 45, 3);
  Options narrow;
  narrow.mapping = Mapping::Narrow;
  const auto wide = denoiseSequence(*sequence, firstFrames(3), Settings("guided"), {}, addGloss);
  const auto again = denoiseSequence(*sequence, firstFrames(3), Settings("guided"), {}, addGloss);
  const auto one = denoiseSequence(*sequence, firstFrames(3), Settings("guided"), narrow, addGloss);
  CHECK(wide.hash == again.hash);
  CHECK(encodedRmse(wide.frames.back().linear, one.frames.back().linear) < 1e-4);
}

}  // namespace quell::tests
