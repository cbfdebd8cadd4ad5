// The whole methods svgf and atrous: real data against references, two signals, constants, broken pixels, odd sizes,
// determinism.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/pipelines/colonnade.hpp"

namespace quell::tests {
namespace {

const std::string kMethods[] = {"svgf", "atrous"};
// Errors on data/colonnade, frame 15, measured on PoCL 3.1.
constexpr double kSvgfUnbiasedRmse = 0.0664;
constexpr double kSvgfSsim = 0.830;
constexpr double kAtrousUnbiasedRmse = 0.0924;

std::unique_ptr<io::FrameSequence> colonnade() {
  return io::openSequence(std::string(QUELL_DATA_DIR) + "/colonnade");
}

metrics::ErrorFigures compareLast(const io::FrameSequence& sequence, const io::Image& image) {
  const auto reference = sequence.reference(15, io::ReferenceKind::Centre);
  return metrics::compareToReference(image, false, reference.a, reference.b);
}

Settings withSetting(const std::string& method, const std::string& name, const std::string& value) {
  Settings settings(method);
  settings.set(name, value);
  return settings;
}

}  // namespace

TEST_CASE("svgf and atrous denoise the sequence in data/ to their known errors", "[pipelines]") {
  const auto sequence = colonnade();
  const auto errorsOf = [&](const Settings& settings) {
    return compareLast(*sequence,
                       denoiseSequence(*sequence, sequence->frames(), settings).frames.back().linear);
  };
  const auto noisy = compareLast(*sequence, sequence->read(15).radiance);
  const auto svgf = errorsOf(Settings("svgf"));
  const auto atrous = errorsOf(Settings("atrous"));
  // No neighbour is like another: what is left is the mean over time.
  Settings unfiltered("svgf");
  unfiltered.set("iterations", 1.0);
  unfiltered.set("luminanceSigma", 0.01);
  const auto accumulated = errorsOf(unfiltered);
  const auto paper = [&] {
    Settings settings("svgf");
    settings.usePreset("paper");
    return errorsOf(settings);
  }();
  INFO("unbiased RMSE: noisy " << *noisy.at("unbiased_rmse") << ", accumulated "
                               << *accumulated.at("unbiased_rmse") << ", atrous "
                               << *atrous.at("unbiased_rmse") << ", svgf " << *svgf.at("unbiased_rmse")
                               << ", preset paper " << *paper.at("unbiased_rmse") << "; SSIM of svgf "
                               << *svgf.at("ssim"));
  // With 5 % of slack for other devices.
  CHECK(*svgf.at("unbiased_rmse") < kSvgfUnbiasedRmse * 1.05);
  CHECK(*svgf.at("ssim") > kSvgfSsim - 0.02);
  CHECK(*atrous.at("unbiased_rmse") < kAtrousUnbiasedRmse * 1.05);
  CHECK(*svgf.at("unbiased_rmse") < 0.8 * *atrous.at("unbiased_rmse"));
  CHECK(*svgf.at("unbiased_rmse") < 0.8 * *accumulated.at("unbiased_rmse"));
  CHECK(*atrous.at("unbiased_rmse") < 0.5 * *noisy.at("unbiased_rmse"));
  CHECK(*paper.at("unbiased_rmse") < *accumulated.at("unbiased_rmse"));
}

TEST_CASE("svgf and atrous handle images of any size", "[pipelines]") {
  struct Extent {
    int width, height;
  };
  for (const std::string& method : kMethods) {
    for (const Extent size : {Extent{1, 1}, Extent{7, 93}, Extent{33, 31}}) {
      INFO(method << " " << size.width << "x" << size.height);
      const auto sequence = analyticSequence(size.width, size.height, 3);
      checkClean(denoiseSequence(*sequence, firstFrames(3), Settings(method)));
      checkClean(denoiseSequence(*sequence, firstFrames(3), Settings(method), {}, addGloss));
    }
  }
}

TEST_CASE("any number of iterations, either feedback and a stop at roughness run", "[pipelines]") {
  const auto sequence = analyticSequence(70, 45, 3);
  for (const std::string& method : kMethods) {
    std::vector<std::string> hashes;
    for (const int iterations : {1, 3, 7}) {
      const auto result = denoiseSequence(*sequence, firstFrames(3),
                                          withSetting(method, "iterations", std::to_string(iterations)));
      checkClean(result);
      for (const std::string& other : hashes) CHECK(result.hash != other);
      hashes.push_back(result.hash);
    }
  }
  const auto with = [&](const char* name, const char* value) {
    const auto result =
        denoiseSequence(*sequence, firstFrames(3), withSetting("svgf", name, value), {}, addGloss);
    checkClean(result);
    return result.hash;
  };
  CHECK(with("feedback", "none") != with("feedback", "first"));
  CHECK(with("roughnessSigma", "0.5") != with("roughnessSigma", "0"));
  CHECK(with("demodulate", "none") != with("demodulate", "albedo"));
}

TEST_CASE("a scene in constant light stays as it is", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 5);
  const auto light = [](io::FrameData& frame) {
    for (std::size_t i = 0; i < frame.radiance.pixels.size(); ++i)
      frame.radiance.pixels[i] = 2.0f * frame.albedo.pixels[i] + frame.emission.pixels[i];
  };
  for (const std::string& method : kMethods) {
    const auto result = denoiseSequence(*sequence, firstFrames(5), Settings(method), {}, light);
    for (int i = 0; i < 5; ++i) {
      io::FrameData frame = sequence->read(i);
      light(frame);
      INFO(method << " frame " << i);
      CHECK(largestError(result.frames[std::size_t(i)].linear, frame.radiance) < 1e-5);
    }
  }
}

TEST_CASE("broken pixels reach neither outputs nor history of svgf and atrous", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 12);
  const auto poison = [](int poisons) {
    return [poisons](io::FrameData& frame) {
      addGloss(frame);
      breakPixels(frame, poisons);
    };
  };
  for (const std::string& method : kMethods) {
    const Settings settings = withSetting(method, "roughnessSigma", "0.5");
    checkClean(denoiseSequence(*sequence, firstFrames(4), settings, {}, poison(kPoisons)));
    const auto broken =
        denoiseSequence(*sequence, firstFrames(12), settings, {}, poison(kPoisonsWithoutFireflies));
    const auto whole = denoiseSequence(*sequence, firstFrames(12), settings, {}, addGloss);
    checkClean(broken);
    INFO(method);
    // Nine frames after the last fault next to nothing is left of it.
    CHECK(encodedRmse(broken.frames.back().linear, whole.frames.back().linear) < 0.01);
  }
}

TEST_CASE("svgf and atrous are bit-identical from run to run and for every work-group size", "[pipelines]") {
  const auto sequence = analyticSequence(131, 77, 3);
  for (const std::string& method : kMethods) {
    const auto hashOf = [&](const Options& options) {
      return denoiseSequence(*sequence, firstFrames(3), Settings(method), options).hash;
    };
    const std::string hash = hashOf({});
    INFO(method);
    CHECK(hashOf({}) == hash);
    Options options;
    options.workGroup = {3, 5};
    CHECK(hashOf(options) == hash);
  }
}

TEST_CASE("svgf gives the same picture with one pixel a work-item as with sixteen", "[pipelines]") {
  const auto sequence = analyticSequence(70, 45, 3);
  Options narrow;
  narrow.mapping = Mapping::Narrow;
  for (const std::string& method : kMethods) {
    const auto wide = denoiseSequence(*sequence, firstFrames(3), Settings(method), {}, addGloss);
    const auto one = denoiseSequence(*sequence, firstFrames(3), Settings(method), narrow, addGloss);
    CHECK(encodedRmse(wide.frames.back().linear, one.frames.back().linear) < 1e-5);
  }
}

TEST_CASE("resetting the history starts svgf afresh", "[pipelines]") {
  const auto sequence = analyticSequence(64, 48, 3);
  const io::FrameData first = sequence->read(0);
  cli::DenoiseSession session("", Settings("svgf"), {}, first);
  const auto fresh = session.denoise(first);
  session.denoise(sequence->read(1));
  session.denoiser().resetHistory();
  const auto again = session.denoise(first);
  CHECK(again.linear.pixels == fresh.linear.pixels);
  CHECK(again.display.pixels == fresh.display.pixels);
}

}  // namespace quell::tests
