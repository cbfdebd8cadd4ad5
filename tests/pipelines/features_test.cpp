// A whole method with other features than the default ones.
#include <catch2/catch.hpp>
#include <limits>

#include "tests/pipelines/denoise_case.hpp"

namespace quell::tests {
namespace {

constexpr int kWidth = 97, kHeight = 61;

// Patches of two roughnesses.
void addRoughness(io::FrameData& frame) {
  frame.roughness = io::Image(kWidth, kHeight, 1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) frame.roughness.at(x, y, 0) = (x / 9 + y / 7) % 2 == 0 ? 0.1f : 0.8f;
}

Settings makeSettings(const char* solver, const char* windows, const char* features) {
  Settings settings("bmfr");
  settings.set("solver", solver);
  settings.set("windows", windows);
  settings.set("features", features);
  return settings;
}

}  // namespace

TEST_CASE("broken materials never reach an output", "[pipelines]") {
  const auto sequence = analyticSequence(kWidth, kHeight, 4);
  const auto spoil = [](io::FrameData& frame) {
    addRoughness(frame);
    const float poison[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -3.0f, 3e38f};
    for (int i = 0; i < 40; ++i) {
      const int x = (17 * i + frame.number) % kWidth, y = (11 * i) % kHeight;
      frame.roughness.at(x, y, 0) = poison[i % 4];
      frame.albedo.at((x + 5) % kWidth, y, i % 3) = poison[i % 4];
    }
  };
  for (const auto& [solver, windows] :
       {std::pair("householder", "blocks"), std::pair("gram", "blocks"), std::pair("gram", "overlap")}) {
    const Settings settings = makeSettings(solver, windows, "n,w,roughness,roughness3,albedo,sqrt(wx),g");
    const DenoisedSequence broken = denoiseSequence(*sequence, {0, 1, 2, 3}, settings, {}, spoil);
    INFO(solver << " " << windows);
    for (const cli::DenoisedFrame& frame : broken.frames) {
      CHECK(isClean(frame.linear, kMostRadiance));
      CHECK(isClean(frame.display, 1.0f));
    }
  }
}

TEST_CASE("a feature that explains the light is followed", "[pipelines]") {
  const auto sequence = analyticSequence(kWidth, kHeight, 1);
  // Light that depends on the roughness alone.
  const auto paint = [](io::FrameData& frame) {
    addRoughness(frame);
    frame.albedo = frame.emission = io::Image();
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        for (int c = 0; c < 3; ++c) frame.radiance.at(x, y, c) = frame.roughness.at(x, y, 0);
  };
  io::FrameData painted = sequence->read(0);
  paint(painted);
  const auto error = [&](const char* features) {
    const io::Image output =
        denoiseSequence(*sequence, {0}, makeSettings("gram", "blocks", features), {}, paint).frames[0].linear;
    double sum = 0.0;
    for (std::size_t i = 0; i < output.pixels.size(); ++i)
      sum += std::abs(double{output.pixels[i]} - double{painted.radiance.pixels[i]});
    return sum / static_cast<double>(output.pixels.size());
  };
  CHECK(error("n,w,roughness") < 0.01);
  CHECK(error("n,w") > 0.1);
}

TEST_CASE("both solvers and both mappings agree on a list", "[pipelines]") {
  const auto sequence = analyticSequence(kWidth, kHeight, 3);
  const char* list = "n,w,w2,albedo,g,depth";
  Options narrow, wide;
  narrow.mapping = Mapping::Narrow;
  wide.mapping = Mapping::Wide;
  const auto last = [&](const char* solver, const Options& options) {
    return denoiseSequence(*sequence, {0, 1, 2}, makeSettings(solver, "blocks", list), options)
        .frames.back()
        .linear;
  };
  const io::Image first = last("householder", wide);
  CHECK(first.pixels == last("householder", narrow).pixels);
  const io::Image gram = last("gram", wide);
  double sum = 0.0;
  for (std::size_t i = 0; i < gram.pixels.size(); ++i)
    sum += std::abs(double{gram.pixels[i]} - double{first.pixels[i]});
  CHECK(sum / static_cast<double>(gram.pixels.size()) < 0.01);
}

}  // namespace quell::tests
