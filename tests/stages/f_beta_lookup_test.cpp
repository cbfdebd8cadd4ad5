// Lookups in the F_beta table: between texels and at the ends of its axes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/stages/f_beta_probe.hpp"
#include "tests/support/random_images.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

struct LookupErrors {
  double usual = 0.0;    // cosTheta >= kUsualFrom
  double grazing = 0.0;  // below
  double mean = 0.0;
};

std::vector<Query> randomQueries() {
  Random random(11);
  std::vector<Query> queries;
  // More of them where F_beta changes fast: grazing angles, low roughness.
  for (int i = 0; i < 3000; ++i)
    queries.push_back({float(std::pow(random.uniform(), i % 2 == 0 ? 1.0 : 4.0)),
                       float(random.uniform() * (i % 3 == 0 ? 0.15 : 1.0))});
  return queries;
}

LookupErrors lookupErrors(const std::vector<Query>& queries, const std::vector<FBetaTerms>& found,
                          Shadowing shadowing) {
  LookupErrors errors;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double cosTheta = queries[i].cosTheta;
    const double error = largestDifference(found[i], exactFBeta(cosTheta, queries[i].roughness, shadowing));
    double& largest = cosTheta >= kUsualFrom ? errors.usual : errors.grazing;
    largest = std::max(largest, error);
    errors.mean += error / double(queries.size());
  }
  return errors;
}

}  // namespace

TEST_CASE("a lookup at a texel gives the texel") {
  for (const Mapping mapping : kProbedMappings) {
    Probe probe(mapping, Shadowing::Separable);
    std::vector<Query> queries;
    for (int y = 0; y < kFBetaEdge; y += 3)
      for (int x = 0; x < kFBetaEdge; x += 3)
        queries.push_back({float(texelCosTheta(x)), float(texelRoughness(y))});
    const std::vector<FBetaTerms> found = probe.lookUp(queries);
    double largest = 0.0;
    std::size_t i = 0;
    for (int y = 0; y < kFBetaEdge; y += 3)
      for (int x = 0; x < kFBetaEdge; x += 3)
        largest = std::max(largest, largestDifference(found[i++], probe.texels().at(x, y)));
    CHECK(largest < 2e-5);  // coordinates are rounded to 1e-5 texels
  }
}

TEST_CASE("a lookup between texels is close to the integral") {
  for (const Shadowing shadowing : kShadowings) {
    const std::vector<Query> queries = randomQueries();
    const std::vector<FBetaTerms> found = Probe(Mapping::Wide, shadowing).lookUp(queries);
    const std::vector<FBetaTerms> narrow = Probe(Mapping::Narrow, shadowing).lookUp(queries);
    const LookupErrors wide = lookupErrors(queries, found, shadowing);
    double betweenMappings = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i)
      betweenMappings = std::max(betweenMappings, largestDifference(found[i], narrow[i]));
    WARN("bilinear lookup, " << (shadowing == Shadowing::Separable ? "separable" : "height-correlated")
                             << ": largest error " << wide.usual << " for cos(theta) >= " << kUsualFrom
                             << ", " << wide.grazing << " below, mean " << wide.mean);
    CHECK(wide.usual < 3e-4);
    CHECK(wide.grazing < 0.04);
    CHECK(betweenMappings < 1e-5);
  }
}

TEST_CASE("a lookup clamps its arguments, and NaN gives finite values") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::vector<std::pair<Query, Query>> sameAs = {
      {{-1.0f, 0.5f}, {0.0f, 0.5f}},  {{-0.0f, 0.5f}, {0.0f, 0.5f}}, {{1.5f, 0.5f}, {1.0f, 0.5f}},
      {{inf, 0.5f}, {1.0f, 0.5f}},    {{-inf, 0.5f}, {0.0f, 0.5f}},  {{nan, 0.5f}, {0.0f, 0.5f}},
      {{0.5f, -1.0f}, {0.5f, 0.0f}},  {{0.5f, 2.0f}, {0.5f, 1.0f}},  {{0.5f, inf}, {0.5f, 1.0f}},
      {{0.5f, -inf}, {0.5f, 0.0f}},   {{0.5f, nan}, {0.5f, 1.0f}},   {{nan, nan}, {0.0f, 1.0f}},
      {{3e38f, 1e-42f}, {1.0f, 0.0f}}};
  for (const Mapping mapping : kProbedMappings) {
    Probe probe(mapping, Shadowing::HeightCorrelated);
    std::vector<Query> broken, clamped;
    for (const auto& [a, b] : sameAs) {
      broken.push_back(a);
      clamped.push_back(b);
    }
    const std::vector<FBetaTerms> found = probe.lookUp(broken), expected = probe.lookUp(clamped);
    for (std::size_t i = 0; i < found.size(); ++i) {
      INFO("cos(theta) " << broken[i].cosTheta << ", roughness " << broken[i].roughness);
      CHECK(largestDifference(found[i], expected[i]) < 1e-7);
    }
  }
}

// Not a test: prints times. Run by name, with one thread for figures per thread.
TEST_CASE("time of a lookup", "[.]") {
  constexpr int kWidth = 1280, kHeight = 720, kRepeat = 50;
  Random random(3);
  std::vector<Query> smooth, textured, scattered;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float across = float(x) / kWidth, down = float(y) / kHeight;
      smooth.push_back({0.2f + 0.7f * across, 0.1f + 0.8f * down});
      textured.push_back({0.2f + 0.7f * across, float(random.uniform(0.2, 0.6))});
      scattered.push_back({float(random.uniform()), float(random.uniform())});
    }
  }
  for (const Mapping mapping : kProbedMappings) {
    Probe probe(mapping, Shadowing::Separable);
    const double copy = probe.milliseconds("copy", smooth, kRepeat);
    for (const auto& [name, queries] : {std::pair("smooth", &smooth), std::pair("rough texture", &textured),
                                        std::pair("scattered", &scattered)}) {
      const double ms = probe.milliseconds("probe", *queries, kRepeat);
      WARN((mapping == Mapping::Wide ? "wide, " : "narrow, ")
           << name << ": " << ms << " ms, " << ms - copy << " above a copy, "
           << (ms - copy) * 1e6 / (kWidth * kHeight) << " ns a pixel");
    }
  }
}
