#include <algorithm>

#include "tests/cases/tone_map_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(bool isLast) {
  return [isLast](const CaseOptions& options) { return std::make_unique<ToneMapCase>(options, isLast); };
}

// Encodes these values, one a pixel, as grey.
std::vector<float> encode(const std::vector<float>& values, Mapping mapping) {
  CaseOptions options;
  options.size = {int(values.size()), 1};
  options.mapping = mapping;
  ToneMapCase toneMap(options);
  for (int x = 0; x < options.size.width; ++x)
    for (int c = 0; c < 3; ++c) toneMap.linear.at(c, x, 0) = values[std::size_t(x)];
  toneMap.upload();
  toneMap.run();
  const Planes encoded = toneMap.encoded();
  return {encoded.values.begin(), encoded.values.begin() + options.size.width};
}

}  // namespace

TEST_CASE("tone_map agrees with its oracle") { checkSizes(maker(false)); }

TEST_CASE("tone_map writes every layout of the display image") {
  checkLayouts(maker(true), {packed(3), packed(4), packedHalf(4), interleaved(3)});
}

TEST_CASE("tone_map does not depend on the work-group") { checkWorkGroups(maker(false), {"encoded"}); }

TEST_CASE("tone_map keeps 0 and 1, clamps, and never decreases") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    std::vector<float> ramp;
    for (int i = 0; i <= 4096; ++i) ramp.push_back(float(i) / 4096.0f);
    ramp.push_back(2.0f);
    const std::vector<float> encoded = encode(ramp, mapping);
    CHECK(encoded.front() == 0.0f);
    CHECK(encoded[4096] == Approx(1.0).margin(kToneMapTolerance));
    CHECK(encoded[4096] <= 1.0f);
    CHECK(encoded.back() == encoded[4096]);
    CHECK(std::is_sorted(encoded.begin(), encoded.end()));
  }
}

TEST_CASE("tone_map gives values in [0, 1] for any input") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const float value : encode(adversarialValues(), mapping)) {
      CHECK(value >= 0.0f);
      CHECK(value <= 1.0f);
    }
  }
}
