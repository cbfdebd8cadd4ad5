// What all methods have in common: one signal or two, ways to demodulate, and inputs at the edge of the contract.
#include <catch2/catch.hpp>

#include "tests/pipelines/signal_images.hpp"

namespace quell::tests {
namespace {

struct Run {
  std::string name;
  Settings settings;
};

// bmfr with either solver, and quell, which has the stages of svgf. The stop at roughness is for the glossy signal, or for the only one.
std::vector<Run> allRuns() {
  Run gram{"bmfr gram", Settings("bmfr")}, atrous{"atrous", Settings("atrous")},
      quell{"quell", Settings("quell")};
  gram.settings.set("solver", "gram");
  atrous.settings.set("roughnessSigma", 0.0);
  quell.settings.set("roughnessSigma", 0.0);
  quell.settings.set("sharpRoughness", 0.0);
  return {{"bmfr", Settings("bmfr")}, gram, atrous, quell};
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

}  // namespace

TEST_CASE("two signals denoise to the sum of two runs with one", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 4);
  for (const Run& run : allRuns()) {
    INFO(run.name);
    const io::Image both = lastLinear(*sequence, 4, run.settings, addGloss);
    const io::Image glossy = lastLinear(*sequence, 4, run.settings, keepGlossy);
    CHECK(largestError(both, sum(lastLinear(*sequence, 4, run.settings, keepDiffuse), glossy)) < 1e-5);
    CHECK(*std::max_element(glossy.pixels.begin(), glossy.pixels.end()) > 0.1f);
  }
}

TEST_CASE("light that was divided by the caller comes back whole, with F_beta and without", "[pipelines]") {
  const auto sequence = analyticSequence(97, 61, 3);
  const auto twoSignals = [](io::FrameData& frame) {
    demodulatedLight(frame);
    frame.glossyRadiance = frame.radiance;
  };
  for (Run run : allRuns()) {
    for (const char* demodulate : {"none", "albedo", "fbeta"}) {
      run.settings.set("demodulate", demodulate);
      // F_beta varies over the image, so what is divided by it is not constant: filters may change it a little.
      const bool isFBeta = demodulate == std::string("fbeta");
      const double tolerance = isFBeta ? 0.15 : 1e-5;
      for (const bool two : {false, true}) {
        // All kernels of one method; of the others those that least resemble it.
        const bool isUsual = isFBeta ? !two : two && demodulate == std::string("albedo");
        if (run.name != "quell" && !isUsual) continue;
        INFO(run.name << " demodulate=" << demodulate << (two ? ", two signals" : ", one signal"));
        const io::Image output = two ? lastLinear(*sequence, 3, run.settings, twoSignals)
                                     : lastLinear(*sequence, 3, run.settings, demodulatedLight);
        const io::FrameData frame = sequence->read(2);
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
    }
  }
}

TEST_CASE("F_beta changes the filtered signal and asks for roughness", "[pipelines]") {
  const auto sequence = analyticSequence(64, 48, 3);
  for (Run run : allRuns()) {
    INFO(run.name);
    const io::Image albedo = lastLinear(*sequence, 3, run.settings, addGloss);
    run.settings.set("demodulate", "fbeta");
    CHECK(largestError(lastLinear(*sequence, 3, run.settings, addGloss), albedo) > 1e-3);
    CHECK_THROWS_WITH(lastLinear(*sequence, 1, run.settings, [](io::FrameData&) {}),
                      Catch::Matchers::Contains("roughness"));
  }
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
