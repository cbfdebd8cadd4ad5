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

Settings gramSettings() {
  Settings settings("bmfr");
  settings.set("solver", "gram");
  settings.set("windows", "overlap");
  return settings;
}

// The picture of vectors of this width; `sameBits` unless sums of tiles are taken in an order that depends on the width.
void checkWidth(const Settings& settings, Mapping mapping, bool sameBits) {
  io::AnalyticOptions analytic;
  analytic.width = kWidth;
  analytic.height = kHeight;
  analytic.frameCount = 3;
  analytic.skyShare = 0.3;  // widths differ in what they can leave out
  const auto sequence = io::makeAnalyticSequence(analytic);
  const auto last = [&](Mapping width) {
    Options options;
    options.mapping = width;
    return denoiseSequence(*sequence, {0, 1, 2}, settings, options).frames.back();
  };
  const auto sixteen = last(Mapping::Wide16), other = last(mapping);
  INFO(settings.method() << ", " << factsOf(mapping).name);
  if (sameBits) CHECK(other.linear.pixels == sixteen.linear.pixels);
  CHECK(encodedRmse(other.linear, sixteen.linear) < kLastDigits);
  if (sameBits) CHECK(other.display.pixels == sixteen.display.pixels);
  CHECK(encodedRmse(other.display, sixteen.display) < kLastDigits);
}

}  // namespace

// One width a method: to compile takes a second a stage.
TEST_CASE("vectors of eight, and of four, give the picture that sixteen give", "[pipelines]") {
  checkWidth(Settings("quell"), Mapping::Wide4, true);
  checkWidth(Settings("bmfr"), Mapping::Wide8, true);
  checkWidth(gramSettings(), Mapping::Wide8, false);
}

TEST_CASE("every other width gives the picture that sixteen give", "[pipelines][.long]") {
  checkWidth(Settings("quell"), Mapping::Wide8, true);
  checkWidth(Settings("bmfr"), Mapping::Wide4, true);
  checkWidth(gramSettings(), Mapping::Wide4, false);
}

}  // namespace quell::tests
