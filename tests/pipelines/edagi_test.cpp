// The whole method edagi: real data against references, hit distances, constants, broken pixels, sizes.
#include <catch2/catch.hpp>
#include <functional>

#include "tests/pipelines/colonnade.hpp"
#include "tests/support/error_matcher.hpp"

namespace quell::tests {
namespace {

// Errors on data/colonnade, frame 15, measured on PoCL 3.1: with the defaults, and as published.
constexpr double kUnbiasedRmse = 0.0692;
constexpr double kSsim = 0.793;
constexpr double kPaperUnbiasedRmse = 0.1450;
constexpr float kMirrorDistance = 3.0f;  // scene units

Settings withSetting(const std::string& name, const std::string& value) {
  Settings settings("edagi");
  settings.set(name, value);
  return settings;
}

void addHits(io::FrameData& frame) {
  addGloss(frame);
  frame.hitDistance = image(frame, 1, kMirrorDistance);
}

}  // namespace

TEST_CASE("edagi denoises the sequence in data/ to its known errors", "[pipelines]") {
  Settings paper("edagi");
  paper.usePreset("paper");
  const auto usual = errorsOnColonnade(Settings("edagi"));
  const auto published = errorsOnColonnade(paper);
  INFO("unbiased RMSE " << *usual.at("unbiased_rmse") << ", SSIM " << *usual.at("ssim") << "; preset paper "
                        << *published.at("unbiased_rmse"));
  // With 5 % of slack for other devices.
  CHECK(*usual.at("unbiased_rmse") < kUnbiasedRmse * 1.05);
  CHECK(*usual.at("ssim") > kSsim - 0.02);
  CHECK(*published.at("unbiased_rmse") < kPaperUnbiasedRmse * 1.05);
}

TEST_CASE("edagi handles images of any size", "[pipelines]") {
  for (const Size size : {Size{1, 1}, Size{7, 93}, Size{33, 31}}) {
    INFO(size.width << "x" << size.height);
    const auto sequence = analyticSequence(size.width, size.height, 3);
    checkClean(denoiseSequence(*sequence, firstFrames(3), Settings("edagi")));
    checkClean(denoiseSequence(*sequence, firstFrames(3), Settings("edagi"), {}, addHits));
  }
}

TEST_CASE("edagi leaves constant light as it is", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 4);
  const auto light = [](io::FrameData& frame) {
    for (std::size_t i = 0; i < frame.radiance.pixels.size(); ++i)
      frame.radiance.pixels[i] = 2.0f * frame.albedo.pixels[i] + frame.emission.pixels[i];
  };
  const auto result = denoiseSequence(*sequence, firstFrames(4), Settings("edagi"), {}, light);
  for (int i = 0; i < 4; ++i) {
    io::FrameData frame = sequence->read(i);
    light(frame);
    CHECK(largestError(result.frames[std::size_t(i)].linear, frame.radiance) < 1e-5);
  }
}

TEST_CASE("broken pixels reach neither outputs nor history of edagi", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 12);
  const auto poison = [](int poisons) {
    return [poisons](io::FrameData& frame) {
      addHits(frame);
      breakPixels(frame, poisons);
    };
  };
  const Settings settings("edagi");
  checkClean(denoiseSequence(*sequence, firstFrames(4), settings, {}, poison(kPoisons)));
  checkClean(denoiseSequence(*sequence, firstFrames(12), settings, {}, poison(kPoisonsWithoutFireflies)));
}

TEST_CASE("hit distances, each setting of its own and either mapping count in edagi", "[pipelines]") {
  const auto sequence = analyticSequence(70, 45, 4);
  const auto hashOf = [&](const Settings& settings, const std::function<void(io::FrameData&)>& edit) {
    const auto result = denoiseSequence(*sequence, firstFrames(4), settings, {}, edit);
    checkClean(result);
    return result.hash;
  };
  const std::string usual = hashOf(Settings("edagi"), addHits);
  CHECK(hashOf(Settings("edagi"), addHits) == usual);
  CHECK(hashOf(Settings("edagi"), addGloss) != usual);
  for (const char* name : {"hysteresis", "clampSigma", "historyRadiusShare", "glossySigma"})
    CHECK(hashOf(withSetting(name, "0.05"), addHits) != usual);
  CHECK(hashOf(withSetting("meanFirst", "off"), addHits) != usual);
  CHECK(hashOf(withSetting("suppressFireflies", "off"), addHits) != usual);
  Options narrow;
  narrow.mapping = Mapping::Narrow;
  const auto wide = denoiseSequence(*sequence, firstFrames(4), Settings("edagi"), {}, addHits);
  const auto one = denoiseSequence(*sequence, firstFrames(4), Settings("edagi"), narrow, addHits);
  CHECK(encodedRmse(wide.frames.back().linear, one.frames.back().linear) < 1e-4);
}

TEST_CASE("edagi refuses limits of distance in the wrong order", "[pipelines]") {
  const auto sequence = analyticSequence(16, 16, 1);
  CHECK_THROWS_MATCHES(denoiseSequence(*sequence, firstFrames(1), withSetting("nearFootprints", "9")), Error,
                       failsWith(ErrorCode::InvalidArgument, {"farFootprints", "8"}));
}

}  // namespace quell::tests
