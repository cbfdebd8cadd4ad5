// What all methods have in common: one signal or two, ways to demodulate, and inputs at the edge of the contract.
#include <catch2/catch.hpp>

#include "tests/pipelines/signal_images.hpp"

namespace quell::tests {
namespace {

struct Run {
  std::string name;
  Settings settings;
};

// The fit of blocks, and quell, which has the stages of svgf. The stop at roughness is for the glossy signal, or for the
// only one.
std::vector<Run> usualRuns() {
  Run quell{"quell", Settings("quell")};
  quell.settings.set("roughnessSigma", 0.0);
  quell.settings.set("sharpRoughness", 0.0);
  return {{"bmfr", Settings("bmfr")}, quell};
}

// Whose stages are in the others, or have their signals in tests of their own.
std::vector<Run> furtherRuns() {
  Run gram{"bmfr gram", Settings("bmfr")}, atrous{"atrous", Settings("atrous")};
  gram.settings.set("solver", "gram");
  atrous.settings.set("roughnessSigma", 0.0);
  return {gram, atrous};
}

std::vector<Run> allRuns() {
  std::vector<Run> runs = usualRuns();
  for (const Run& run : furtherRuns()) runs.push_back(run);
  return runs;
}

io::Image lastLinear(const io::FrameSequence& sequence, int frames, const Settings& settings,
                     const std::function<void(io::FrameData&)>& edit) {
  return denoiseSequence(sequence, firstFrames(frames), settings, {}, edit).frames.back().linear;
}

// Irradiance 1 that the caller has divided by albedo 1/4 and gloss colour 1/2, or by their sum.
void demodulatedLight(io::FrameData& frame) {
  frame.radiance = image(frame, 3, 1.0f);
  frame.albedo = image(frame, 3, 0.25f);
  frame.glossColor = image(frame, 3, 0.5f);
  frame.roughness = image(frame, 1, 0.3f);
  frame.f0 = image(frame, 3, 0.8f);
  frame.emission = io::Image();
  frame.demodulated = true;
}

bool isSurface(const io::FrameData& frame, int x, int y) { return frame.albedo.at(x, y, 0) > 0.0f; }

void checkSignals(const Run& run) {
  INFO(run.name);
  const auto sequence = analyticSequence(97, 61, 4);
  const io::Image both = lastLinear(*sequence, 4, run.settings, addGloss);
  const io::Image glossy = lastLinear(*sequence, 4, run.settings, keepGlossy);
  CHECK(largestError(both, sum(lastLinear(*sequence, 4, run.settings, keepDiffuse), glossy)) < 1e-5);
  CHECK(*std::max_element(glossy.pixels.begin(), glossy.pixels.end()) > 0.1f);
}

// Light that was divided by the caller comes back whole.
void checkDividedLight(const Run& run, const char* demodulate, bool two) {
  INFO(run.name << " demodulate=" << demodulate << (two ? ", two signals" : ", one signal"));
  const auto sequence = analyticSequence(97, 61, 3);
  Settings settings = run.settings;
  settings.set("demodulate", demodulate);
  const auto twoSignals = [](io::FrameData& frame) {
    demodulatedLight(frame);
    frame.glossyRadiance = frame.radiance;
  };
  const io::Image output = two ? lastLinear(*sequence, 3, settings, twoSignals)
                               : lastLinear(*sequence, 3, settings, demodulatedLight);
  const io::FrameData frame = sequence->read(2);
  // F_beta varies over the image, so what is divided by it is not constant: filters may change it a little.
  const double tolerance = demodulate == std::string("fbeta") ? 0.15 : 1e-5;
  double mean = 0.0, count = 0.0;
  for (int y = 0; y < 61; ++y) {
    for (int x = 0; x < 97; ++x) {
      if (!isSurface(frame, x, y)) continue;
      CHECK(output.at(x, y, 1) == Approx(0.75).epsilon(tolerance));
      mean += output.at(x, y, 1);
      count += 1.0;
    }
  }
  CHECK(mean / count == Approx(0.75).epsilon(0.01));
}

void checkFBeta(Run run) {
  INFO(run.name);
  const auto sequence = analyticSequence(64, 48, 3);
  const io::Image albedo = lastLinear(*sequence, 3, run.settings, addGloss);
  run.settings.set("demodulate", "fbeta");
  CHECK(largestError(lastLinear(*sequence, 3, run.settings, addGloss), albedo) > 1e-3);
  CHECK_THROWS_WITH(lastLinear(*sequence, 1, run.settings, [](io::FrameData&) {}),
                    Catch::Matchers::Contains("roughness"));
}

}  // namespace

TEST_CASE("two signals denoise to the sum of two runs with one", "[pipelines]") {
  for (const Run& run : usualRuns()) checkSignals(run);
}

TEST_CASE("two signals of further methods denoise to the sum of two runs with one", "[pipelines][.long]") {
  for (const Run& run : furtherRuns()) checkSignals(run);
}

// Every way to divide, one signal and two: each once on some method.
TEST_CASE("light that was divided by the caller comes back whole, with F_beta and without", "[pipelines]") {
  const std::vector<Run> runs = usualRuns();
  checkDividedLight(runs[0], "albedo", true);
  checkDividedLight(runs[0], "fbeta", false);
  checkDividedLight(runs[1], "none", false);
  checkDividedLight(runs[1], "albedo", false);
  checkDividedLight(runs[1], "fbeta", true);
}

TEST_CASE("light that was divided by the caller comes back whole, whatever the method",
          "[pipelines][.long]") {
  for (const char* demodulate : {"none", "albedo", "fbeta"})
    for (const bool two : {false, true}) checkDividedLight(usualRuns()[1], demodulate, two);
  for (const Run& run : furtherRuns()) {
    checkDividedLight(run, "albedo", true);
    checkDividedLight(run, "fbeta", false);
  }
}

TEST_CASE("F_beta changes the filtered signal and asks for roughness", "[pipelines]") {
  for (const Run& run : usualRuns()) checkFBeta(run);
}

TEST_CASE("F_beta changes the filtered signal of further methods", "[pipelines][.long]") {
  for (const Run& run : furtherRuns()) checkFBeta(run);
}

TEST_CASE("the length of normals does not matter", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 3);
  for (const Run& run : allRuns()) {
    const io::Image unit = lastLinear(*sequence, 3, run.settings, {});
    for (const float length : {0.3f, 1e-3f, 100.0f}) {
      const io::Image scaled = lastLinear(*sequence, 3, run.settings, [&](io::FrameData& frame) {
        for (float& component : frame.normalWorld.pixels) component *= length;
      });
      INFO(run.name << ", length " << length);
      CHECK(encodedRmse(unit, scaled) < 1e-3);
    }
  }
}

TEST_CASE("negative emission counts as none", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 4);
  const auto without = [](io::FrameData& frame) { frame.emission = image(frame, 3, 0.0f); };
  const auto negative = [](io::FrameData& frame) {
    frame.emission = image(frame, 3, frame.number == 1 ? -1000.0f : 0.0f);
  };
  for (const Run& run : allRuns()) {
    INFO(run.name);
    CHECK(largestError(lastLinear(*sequence, 4, run.settings, negative),
                       lastLinear(*sequence, 4, run.settings, without)) == 0.0);
  }
}

TEST_CASE("small work-groups of the fit give the same picture", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 2);
  for (const char* solver : {"householder", "gram"}) {
    Settings settings("bmfr");
    settings.set("solver", solver);
    std::string first;
    for (const int group : {64, 8, 1}) {
      Options options;
      options.mapping = Mapping::Narrow;
      options.fitGroup = group;
      const std::string hash = denoiseSequence(*sequence, firstFrames(2), settings, options).hash;
      if (first.empty()) first = hash;
      INFO(solver << " " << group);
      CHECK(hash == first);
    }
  }
}

}  // namespace quell::tests
