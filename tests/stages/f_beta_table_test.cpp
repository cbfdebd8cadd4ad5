// The F_beta table against a double-precision quadrature, its limits, and its disk cache.
#include "host/stages/f_beta_table.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "kernels/f_beta_table_params.h"
#include "tests/oracle/f_beta_oracle.hpp"
#include "tests/support/f_beta_texels.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/temporary_directory.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

namespace fs = std::filesystem;

// Largest absolute error of scale and bias at a texel. 2e-3, and 5e-4 for roughness >= 0.1, are what a denoiser needs;
// the lattice gives 9.1e-5 over the whole table.
constexpr double kTexelTolerance = 1.5e-4;
constexpr double kRoughFrom = 0.1;
// Rounding of a sum of thousands of floats that adds up to 1.
constexpr double kSumRounding = 1e-5;

struct TexelErrors {
  double all = 0.0, rough = 0.0;
  int x = 0, y = 0;  // of the largest
};

// Every texel whose column and row are multiples of `step`, and all within 3 texels of the borders.
TexelErrors compareTexels(const FBetaTexels& texels, Shadowing shadowing, int step) {
  const auto taken = [&](int i) { return i % step == 0 || i < 4 || i >= kFBetaEdge - 4; };
  TexelErrors errors;
  for (int y = 0; y < kFBetaEdge; ++y) {
    for (int x = 0; x < kFBetaEdge; ++x) {
      if (!taken(x) || !taken(y)) continue;
      const double error = largestDifference(texels.at(x, y), exactTexel(x, y, shadowing));
      if (!(error <= errors.all)) errors = {error, errors.rough, x, y};
      if (texelRoughness(y) >= kRoughFrom) errors.rough = std::max(errors.rough, error);
    }
  }
  return errors;
}

void checkTexels(Mapping mapping, Shadowing shadowing, int step) {
  const TexelErrors errors = compareTexels(sharedFBetaTexels(mapping, shadowing), shadowing, step);
  INFO((mapping == Mapping::Wide ? "wide, " : "narrow, ")
       << (shadowing == Shadowing::Separable ? "separable" : "height-correlated") << ": largest error "
       << errors.all << " at column " << errors.x << " row " << errors.y << ", " << errors.rough
       << " for roughness >= " << kRoughFrom);
  CHECK(errors.all <= kTexelTolerance);
  if (step == 1)
    WARN("whole table, " << (shadowing == Shadowing::Separable ? "separable" : "correlated") << ": "
                         << errors.all << ", rough " << errors.rough);
}

constexpr Shadowing kShadowings[] = {Shadowing::Separable, Shadowing::HeightCorrelated};

using Bytes = std::vector<char>;

Bytes readFile(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return Bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

void writeFile(const fs::path& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

// The directory holds a program, too; the table is the entry that is as large as a table at least.
fs::path tableFile(const std::string& directory) {
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.file_size() > sizeof(float) * QUELL_F_BETA_ENTRY * kFBetaEdge * kFBetaEdge) return entry.path();
  FAIL("no table in " << directory);
  return {};
}

}  // namespace

TEST_CASE("the oracle of F_beta has converged and agrees with brute force") {
  double change = 0.0, difference = 0.0;
  for (const Shadowing shadowing : kShadowings) {
    for (int y = 1; y < kFBetaEdge; y += 23)
      for (int x = 0; x < kFBetaEdge; x += 15)
        change = std::max(change, largestDifference(exactTexel(x, y, shadowing),
                                                    exactTexel(x, y, shadowing, 2 * kFBetaOracleOrder)));
    for (const double roughness : {0.5, 0.75, 1.0}) {
      const GgxSurface surface{roughness, shadowing == Shadowing::HeightCorrelated};
      for (const double cosTheta : {0.1, 0.3, 0.7, 0.99})
        difference = std::max(difference, largestDifference(fBetaOracle(surface, cosTheta),
                                                            fBetaBruteForce(surface, cosTheta, 400)));
    }
  }
  INFO("twice the order: " << change << ", brute force: " << difference);
  CHECK(change < 1e-6);
  CHECK(difference < 2e-5);
}

TEST_CASE("f_beta_table agrees with its oracle") {
  for (const Shadowing shadowing : kShadowings) checkTexels(Mapping::Wide, shadowing, 8);
}

// A minute: run by name.
TEST_CASE("f_beta_table agrees with its oracle at every texel", "[.]") {
  for (const Shadowing shadowing : kShadowings) checkTexels(Mapping::Wide, shadowing, 1);
}

// With one lane a table takes seconds on a CPU: one of the two will do.
TEST_CASE("f_beta_table hardly depends on the mapping") {
  const FBetaTexels& wide = sharedFBetaTexels(Mapping::Wide, Shadowing::HeightCorrelated);
  const FBetaTexels& narrow = sharedFBetaTexels(Mapping::Narrow, Shadowing::HeightCorrelated);
  double difference = 0.0;
  for (int y = 0; y < kFBetaEdge; ++y)
    for (int x = 0; x < kFBetaEdge; ++x)
      difference = std::max(difference, largestDifference(wide.at(x, y), narrow.at(x, y)));
  CHECK(difference < kSumRounding);
}

TEST_CASE("F_beta of a mirror is Schlick's Fresnel term, and roughness near 0 comes close") {
  for (const Shadowing shadowing : kShadowings) {
    const FBetaTexels& texels = sharedFBetaTexels(Mapping::Wide, shadowing);
    for (int x = 0; x < kFBetaEdge; ++x) {
      const double cosTheta = texelCosTheta(x), fresnel = std::pow(1.0 - cosTheta, 5.0);
      INFO("cos(theta) " << cosTheta);
      CHECK(texels.at(x, 0).bias == Approx(fresnel).margin(1e-6));
      CHECK(texels.at(x, 0).scale == Approx(1.0 - fresnel).margin(1e-6));
      if (cosTheta < 0.05) continue;
      double previous = 0.0;
      for (const int y : {1, 2, 4, 8}) {  // alpha up to 1e-3
        const double distance = largestDifference(texels.at(x, y), texels.at(x, 0));
        CHECK(distance < 1e-3);
        CHECK(distance >= previous - kSumRounding);
        previous = distance;
      }
    }
  }
}

TEST_CASE("a white surface loses energy, and the more the rougher it is") {
  // Nearer to grazing single scattering first loses and then regains with roughness: masked light comes back.
  constexpr double kMonotoneFrom = 0.16;
  for (const Shadowing shadowing : kShadowings) {
    const FBetaTexels& texels = sharedFBetaTexels(Mapping::Wide, shadowing);
    for (int x = 0; x < kFBetaEdge; x += 3) {
      double previous = 1.0;
      for (int y = 0; y < kFBetaEdge; ++y) {
        const FBetaTerms texel = texels.at(x, y);
        const double reflected = texel.scale + texel.bias;
        INFO("column " << x << " row " << y);
        REQUIRE(texel.scale >= 0.0);
        REQUIRE(texel.bias >= 0.0);
        REQUIRE(reflected <= 1.0 + kSumRounding);
        if (texelCosTheta(x) >= kMonotoneFrom) REQUIRE(reflected <= previous + kSumRounding);
        previous = reflected;
      }
    }
    const FBetaTerms roughest = texels.at(kFBetaEdge - 1, kFBetaEdge - 1);
    CHECK(roughest.scale + roughest.bias < 0.35);  // two thirds are scattered more than once
  }
}

TEST_CASE("the two kinds of masking-shadowing agree for mirrors and part at grazing angles") {
  const FBetaTexels& separable = sharedFBetaTexels(Mapping::Wide, Shadowing::Separable);
  const FBetaTexels& correlated = sharedFBetaTexels(Mapping::Wide, Shadowing::HeightCorrelated);
  double difference = 0.0;
  for (int y = 0; y < kFBetaEdge; ++y) {
    for (int x = 0; x < kFBetaEdge; ++x) {
      const FBetaTerms a = separable.at(x, y), b = correlated.at(x, y);
      REQUIRE(b.scale + b.bias >= a.scale + a.bias - kSumRounding);
      difference = std::max(difference, b.scale + b.bias - a.scale - a.bias);
      if (y == 0) CHECK(largestDifference(a, b) == 0.0);
    }
  }
  CHECK(difference == Approx(0.386).margin(0.002));
}

TEST_CASE("the BRDF of F_beta is reciprocal") {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const GgxSurface surface{random.uniform(0.02, 1.0), i % 2 == 1};
    const double out = random.uniform(0.001, 1.0), in = random.uniform(0.001, 1.0);
    const double phi = random.uniform(0.0, 3.14);
    const double value = ggxBrdf(surface, out, in, phi);
    REQUIRE(value > 0.0);
    REQUIRE(ggxBrdf(surface, in, out, phi) == Approx(value).epsilon(1e-12));
  }
}

TEST_CASE("f_beta_table is built once and read from disk the next time") {
  const TemporaryDirectory directory;
  const FBetaTexels compilerStarted(Mapping::Automatic, Shadowing::Separable);  // a second, once a process
  const auto timed = [&](const std::string& path, Shadowing shadowing, bool fromDisk) {
    const auto start = std::chrono::steady_clock::now();
    const FBetaTexels texels(Mapping::Automatic, shadowing, path);
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    CHECK(texels.fromDisk() == fromDisk);
    return std::pair(wall.count(), texels.values());
  };
  for (const Shadowing shadowing : kShadowings) {
    const auto built = timed(directory.path(), shadowing, false);
    const auto read = timed(directory.path(), shadowing, true);
    WARN("with compiler and read-back " << built.first << " ms, from disk " << read.first << " ms");
    CHECK(built.second == read.second);
    CHECK(timed("", shadowing, false).second == read.second);
  }
}

TEST_CASE("a damaged table on disk is computed again and replaced") {
  const TemporaryDirectory directory;
  const Shadowing shadowing = Shadowing::Separable;
  const std::vector<float> expected = FBetaTexels(Mapping::Automatic, shadowing, directory.path()).values();
  const fs::path path = tableFile(directory.path());
  const Bytes whole = readFile(path);
  std::vector<Bytes> damaged = {{}, Bytes(whole.begin(), whole.end() - 1), Bytes(100, 'x')};
  for (const std::size_t place : {std::size_t{0}, std::size_t{25}, whole.size() / 2, whole.size() - 1}) {
    damaged.push_back(whole);
    damaged.back()[place] = char(damaged.back()[place] ^ 1);
  }
  for (const Bytes& bytes : damaged) {
    writeFile(path, bytes);
    const FBetaTexels rebuilt(Mapping::Automatic, shadowing, directory.path());
    CHECK_FALSE(rebuilt.fromDisk());
    CHECK(rebuilt.values() == expected);
    CHECK(readFile(path) == whole);
  }
}

TEST_CASE("f_beta_table works without a place to keep it") {
  const TemporaryDirectory directory;
  writeFile(directory.file("file"), {'x'});
  for (const std::string& path : {std::string(), directory.file("file") + "/cache"}) {
    const FBetaTexels texels(Mapping::Automatic, Shadowing::Separable, path);
    CHECK_FALSE(texels.fromDisk());
    CHECK(texels.at(0, 0).bias == 1.0);
  }
  CHECK(readFile(directory.file("file")) == Bytes{'x'});
}
