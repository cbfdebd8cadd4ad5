// The whole method quell: real data against references and the other methods, light that changes and light that stays,
// odd sizes, broken pixels.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "host/io/frame_sequence.hpp"
#include "host/metrics/report.hpp"
#include "tests/pipelines/signal_images.hpp"

namespace quell::tests {
namespace {

// Error on data/colonnade, frame 15, measured on PoCL 3.1.
constexpr double kDataUnbiasedRmse = 0.0613;

constexpr int kStepFrame = 8;  // from which on there is twice the light

// White surfaces in the same light everywhere, under uniform noise as large as the light itself.
void evenLight(io::FrameData& frame, float level) {
  std::mt19937 generator(unsigned(frame.number) + 1);
  for (float& value : frame.radiance.pixels)
    value = level * 2.0f * float(double(generator()) / double(std::mt19937::max()));
  std::fill(frame.albedo.pixels.begin(), frame.albedo.pixels.end(), 1.0f);
  std::fill(frame.emission.pixels.begin(), frame.emission.pixels.end(), 0.0f);
}

// Light of every frame before a still camera; from kStepFrame on `step` times as much.
std::vector<Light> denoiseLight(const Settings& settings, float step) {
  const int frames = kStepFrame + 4;
  const auto sequence = analyticSequence(121, 77, frames, {0.0, 0.0, 0.0}, 0, false);
  const auto result = denoiseSequence(
      *sequence, firstFrames(frames), settings, {},
      [&](io::FrameData& frame) { evenLight(frame, frame.number >= kStepFrame ? step : 1.0f); });
  std::vector<Light> light;
  for (int i = 0; i < frames; ++i)
    light.push_back(lightOf(result.frames[std::size_t(i)].linear, sequence->read(i).normalWorld));
  return light;
}

// The method without the stages that follow change.
Settings withoutChange() {
  Settings settings("quell");
  settings.set("mostWeight", 0.0);
  return settings;
}

void checkClean(const DenoisedSequence& result) {
  for (const cli::DenoisedFrame& frame : result.frames) {
    CHECK(isClean(frame.linear, kMostRadiance));
    CHECK(isClean(frame.display, 1.0f));
  }
}

}  // namespace

TEST_CASE("quell denoises the sequence in data/ better than svgf and bmfr", "[pipelines]") {
  const auto sequence = io::openSequence(std::string(QUELL_DATA_DIR) + "/colonnade");
  const auto reference = sequence->reference(15, io::ReferenceKind::Centre);
  const auto errorOf = [&](const char* method) {
    const auto result = denoiseSequence(*sequence, sequence->frames(), Settings(method));
    return *metrics::compareToReference(result.frames.back().linear, false, reference.a, reference.b)
                .at("unbiased_rmse");
  };
  const double quell = errorOf("quell"), svgf = errorOf("svgf"), bmfr = errorOf("bmfr");
  INFO("unbiased RMSE: quell " << quell << ", svgf " << svgf << ", bmfr " << bmfr);
  CHECK(quell < kDataUnbiasedRmse * 1.05);  // slack for other devices
  CHECK(quell < svgf);
  CHECK(quell < bmfr);
}

TEST_CASE("quell follows light that doubles within two frames", "[pipelines]") {
  const std::vector<Light> light = denoiseLight(Settings("quell"), 2.0f);
  const std::vector<Light> slow = denoiseLight(withoutChange(), 2.0f);
  INFO("mean light before the step, at it and two frames later: "
       << light[kStepFrame - 1].mean << " " << light[kStepFrame].mean << " " << light[kStepFrame + 2].mean);
  CHECK(light[kStepFrame - 1].mean == Approx(1.0).epsilon(0.02));
  for (std::size_t i = kStepFrame + 2; i < light.size(); ++i)
    CHECK(light[i].mean == Approx(2.0).epsilon(0.1));
  CHECK(slow[kStepFrame + 2].mean < 0.9 * 2.0);
}

TEST_CASE("quell keeps its history where light stays", "[pipelines]") {
  const std::vector<Light> light = denoiseLight(Settings("quell"), 1.0f);
  const std::vector<Light> still = denoiseLight(withoutChange(), 1.0f);
  Settings forgetful("quell");
  forgetful.set("historyFrames", 1.0);
  forgetful.set("stillHistoryFrames", 1.0);
  const std::vector<Light> newest = denoiseLight(forgetful, 1.0f);
  for (const Light& frame : light) CHECK(frame.mean == Approx(1.0).epsilon(0.02));
  INFO("deviation: " << light.back().deviation << ", never following change " << still.back().deviation
                     << ", without history " << newest.back().deviation);
  CHECK(light.back().deviation < 1.25 * still.back().deviation);
  CHECK(light.back().deviation < 0.7 * newest.back().deviation);
}

TEST_CASE("quell handles images of any size", "[pipelines]") {
  struct Extent {
    int width, height;
  };
  for (const Extent size : {Extent{1, 1}, Extent{7, 93}, Extent{33, 31}}) {
    INFO(size.width << "x" << size.height);
    const auto sequence = analyticSequence(size.width, size.height, 3);
    checkClean(denoiseSequence(*sequence, firstFrames(3), Settings("quell")));
    checkClean(denoiseSequence(*sequence, firstFrames(3), Settings("quell"), {}, addGloss));
  }
}

TEST_CASE("quell is bit-identical from run to run and starts afresh after a reset", "[pipelines]") {
  const auto sequence = analyticSequence(70, 45, 5);
  const auto first = denoiseSequence(*sequence, firstFrames(5), Settings("quell"), {}, addGloss);
  CHECK(denoiseSequence(*sequence, firstFrames(5), Settings("quell"), {}, addGloss).hash == first.hash);
  io::FrameData frame = sequence->read(0);
  addGloss(frame);
  cli::DenoiseSession session("", Settings("quell"), {}, frame);
  io::FrameData next = sequence->read(1);
  addGloss(next);
  for (const io::FrameData* each : {&frame, &next, &next}) session.denoise(*each);
  session.denoiser().resetHistory();
  CHECK(session.denoise(frame).linear.pixels == first.frames[0].linear.pixels);
  CHECK(session.denoise(next).linear.pixels == first.frames[1].linear.pixels);
}

TEST_CASE("broken pixels reach neither outputs nor history of quell", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 12);
  const auto poison = [](int poisons) {
    return [poisons](io::FrameData& frame) {
      addGloss(frame);
      breakPixels(frame, poisons);
    };
  };
  const Settings settings("quell");
  checkClean(denoiseSequence(*sequence, firstFrames(4), settings, {}, poison(kPoisons)));
  const auto broken =
      denoiseSequence(*sequence, firstFrames(12), settings, {}, poison(kPoisonsWithoutFireflies));
  const auto whole = denoiseSequence(*sequence, firstFrames(12), settings, {}, addGloss);
  checkClean(broken);
  CHECK(encodedRmse(broken.frames.back().linear, whole.frames.back().linear) < 0.01);
}

}  // namespace quell::tests
