#include <algorithm>

#include "kernels/accumulate_noisy_params.h"
#include "tests/cases/gram_sums_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

constexpr GramWindows kAllWindows[] = {kBlocks, kOverlap8, kOverlap16};

CaseOptions makeOptions(Size size, Mapping mapping, int fitGroup) {
  CaseOptions options;
  options.size = size;
  options.mapping = mapping;
  options.fitGroup = fitGroup;
  return options;
}

std::string describe(const GramWindows& windows) {
  return (windows.overlap ? "overlapping windows of tiles of " : "blocks of ") +
         std::to_string(windows.tileEdge);
}

Planes tilesOf(const CaseOptions& options, const GramWindows& windows) {
  GramSumsCase sums(options, windows);
  sums.uploadAndRun();
  return sums.tiles();
}

}  // namespace

TEST_CASE("gram_sums agrees with its oracle") {
  for (const GramWindows& windows : kAllWindows) {
    for (const auto& [mapping, group] :
         {std::pair(Mapping::Wide, 1), std::pair(Mapping::Narrow, 32), std::pair(Mapping::Narrow, 128)}) {
      for (const Size size : {Size{1, 1}, Size{7, 93}, Size{33, 31}, Size{257, 89}}) {
        const CaseOptions options = makeOptions(size, mapping, group);
        GramSumsCase sums(options, windows);
        INFO(describe(windows));
        checkAgreement(sums, options);
      }
    }
  }
}

TEST_CASE("gram_sums agrees with its oracle on a whole picture") {
  for (const GramWindows& windows : kAllWindows) {
    const CaseOptions options = makeOptions({480, 270}, Mapping::Wide, 1);
    GramSumsCase sums(options, windows);
    INFO(describe(windows));
    checkAgreement(sums, options);
  }
}

TEST_CASE("gram_sums agrees with its oracle at all offsets of the grid") {
  for (const GramWindows& windows : kAllWindows) {
    const CaseOptions options = makeOptions({65, 34}, Mapping::Wide, 1);
    GramSumsCase sums(options, windows);
    for (std::uint32_t frame = 0; frame < 16; ++frame) {
      sums.useFrame(frame);
      INFO(describe(windows) << ", frame " << frame);
      checkAgreement(sums, options);
    }
  }
}

TEST_CASE("gram_sums leaves out tiles of background") {
  for (const GramWindows& windows : kAllWindows)
    checkHoles([&](const CaseOptions& options) { return std::make_unique<GramSumsCase>(options, windows); });
}

TEST_CASE("gram_sums of pixels without weight are 0, whatever those hold") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    const CaseOptions options = makeOptions({33, 31}, mapping, 0);
    GramSumsCase sums(options, kOverlap8);
    forEachPixel(options.size, [&](int x, int y) {
      if (x >= 12 && y >= 9) return;
      sums.inputs.guides.at(QUELL_GUIDE_WEIGHT, x, y) = 0.0f;
      sums.inputs.guides.at(QUELL_GUIDE_POSITION, x, y) = QUELL_MAX_POSITION;
    });
    checkAgreement(sums, options);
    CHECK(allFinite(sums.tiles()));
  }
}

TEST_CASE("gram_sums of the brightest irradiance agree with their oracle") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    const CaseOptions options = makeOptions({77, 43}, mapping, 0);
    GramSumsCase sums(options);
    for (float& value : sums.inputs.irradiance.values) value = value < 4.0f ? 0.0f : QUELL_MAX_RADIANCE;
    checkAgreement(sums, options);
  }
}

TEST_CASE("gram_sums gives the same bits whatever the work-group, and again") {
  for (const GramWindows& windows : kAllWindows) {
    INFO(describe(windows));
    const Planes narrow = tilesOf(makeOptions({77, 43}, Mapping::Narrow, 128), windows);
    for (const int group : {32, 64, 128})
      CHECK(sameBits(narrow, tilesOf(makeOptions({77, 43}, Mapping::Narrow, group), windows)));
    const Planes wide = tilesOf(makeOptions({77, 43}, Mapping::Wide, 0), windows);
    CHECK(sameBits(wide, tilesOf(makeOptions({77, 43}, Mapping::Wide, 16), windows)));
  }
}
