// However many pixels a work-item takes, the picture is the same.
#include <catch2/catch.hpp>

#include "host/core/device_traits.hpp"
#include "tests/pipelines/denoise_case.hpp"

namespace quell::tests {
namespace {

// Neither a multiple of any width nor smaller than one.
constexpr int kWidth = 75;
constexpr int kHeight = 45;
// Of encoded values.
constexpr double kLastDigits = 1e-5;
// Sky is antialiased where it shares a vector with a surface, and left as it is elsewhere.
constexpr double kEdgeOfSky = 5e-3;

Settings gramSettings() {
  Settings settings("bmfr");
  settings.set("solver", "gram");
  settings.set("windows", "overlap");
  return settings;
}

struct MethodCase {
  Settings settings;
  bool sameBits;                  ///< sums of tiles alone are taken in an order that depends on the width
  std::vector<Mapping> narrower;  ///< few: to compile takes seconds a stage
};

}  // namespace

TEST_CASE("vectors of eight, and of four, give the picture that sixteen give", "[pipelines]") {
  io::AnalyticOptions analytic;
  analytic.width = kWidth;
  analytic.height = kHeight;
  analytic.frameCount = 3;
  analytic.skyShare = 0.3;  // widths differ in what they can leave out
  const auto sequence = io::makeAnalyticSequence(analytic);
  for (const MethodCase& method : {MethodCase{Settings("quell"), true, {Mapping::Wide8, Mapping::Wide4}},
                                   MethodCase{Settings("bmfr"), true, {Mapping::Wide8}},
                                   MethodCase{gramSettings(), false, {Mapping::Wide8}}}) {
    const auto last = [&](Mapping mapping) {
      Options options;
      options.mapping = mapping;
      return denoiseSequence(*sequence, {0, 1, 2}, method.settings, options).frames.back();
    };
    const auto sixteen = last(Mapping::Wide16);
    for (const Mapping mapping : method.narrower) {
      const auto other = last(mapping);
      INFO(method.settings.method() << ", " << factsOf(mapping).name);
      if (method.sameBits) CHECK(other.linear.pixels == sixteen.linear.pixels);
      CHECK(encodedRmse(other.linear, sixteen.linear) < kLastDigits);
      CHECK(encodedRmse(other.display, sixteen.display) < kEdgeOfSky);
    }
  }
}

}  // namespace quell::tests
