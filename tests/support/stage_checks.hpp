// What the tests of all stages have in common.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <memory>
#include <vector>

#include "kernels/common/guides.h"
#include "tests/cases/stage_case.hpp"

namespace quell::tests {

/// Smaller than a work-item's lanes, off every multiple, wider than high and the other way round.
inline std::vector<Size> testSizes() { return {{1, 1}, {7, 93}, {257, 89}, {33, 31}, {480, 270}}; }

constexpr double kDarkLight = 1e-3;
constexpr int kMostDarkPixels = 5000;

/// Layouts that take different paths in common/image_access.h.
inline std::vector<ImageLayout> outputLayouts() {
  return {packed(4), packedHalf(3), packedHalf(4), interleaved(3), interleaved(4, ComponentFormat::Float16)};
}
inline std::vector<ImageLayout> inputLayouts() {
  return {packed(4),
          packedHalf(3),
          packedHalf(4),
          packed(1),
          packed(2),
          interleaved(3),
          interleaved(4, ComponentFormat::Float16)};
}

/// Sixteen pixels a work-item and one.
inline std::array<CaseOptions, 2> bothMappings(Size size = CaseOptions().size) {
  CaseOptions options;
  options.size = size;
  std::array<CaseOptions, 2> both{options, options};
  both[0].mapping = Mapping::Wide;
  both[1].mapping = Mapping::Narrow;
  return both;
}

inline const char* toString(Mapping mapping) { return mapping == Mapping::Wide ? "wide" : "narrow"; }

inline std::string describe(const CaseOptions& options) {
  return std::to_string(options.size.width) + "x" + std::to_string(options.size.height) + " " +
         toString(options.mapping) + " " + describe(options.layout) + " group " +
         std::to_string(options.workGroup[0]) + "x" + std::to_string(options.workGroup[1]) + " fit group " +
         std::to_string(options.fitGroup);
}

/// Device and oracle agree within the case's tolerance, and few pixels are left out.
inline void checkComparison(const Comparison& comparison, const StageCase& stageCase,
                            const CaseOptions& options) {
  INFO(describe(options));
  INFO(comparison.worst());
  INFO(comparison.excluded() << " pixels left out");
  CHECK(comparison.compared() > 0);
  CHECK(comparison.largestError() <= stageCase.tolerance());
  const double pixels = double(options.size.width) * double(options.size.height);
  CHECK(double(comparison.excluded()) <= 2.0 + kExcludedShare * pixels);
}

/// In a bright scene, which the outputs are of afterwards, and in a dark one unless the picture is large.
inline void checkAgreement(StageCase& stageCase, const CaseOptions& options) {
  checkComparison(stageCase.check(), stageCase, options);
  if (options.size.width * options.size.height > kMostDarkPixels) return;
  INFO("dark");
  checkComparison(stageCase.checkInLight(kDarkLight), stageCase, options);
}

/// The guides of a run with this signal alone.
inline Planes guidesOfSignal(const Planes& both, int signal) {
  Planes guides = planesOf(both, 0, QUELL_GUIDE_PLANES_OF(1));
  forEachPixel(both.size(), [&](int x, int y) {
    guides.at(QUELL_GUIDE_WEIGHT, x, y) = both.at(QUELL_GUIDE_WEIGHT + signal, x, y);
  });
  return guides;
}

/// Compares the planes from `first` on with those of a run with one signal.
inline void compareSignal(Comparison& comparison, const char* name, const Planes& both, int first,
                          const Planes& alone) {
  ExactPlanes expected(alone.size(), alone.count);
  std::copy(alone.values.begin(), alone.values.end(), expected.values.begin());
  comparePixels(comparison, name, planesOf(both, first, alone.count), expected);
}

using CaseMaker = std::function<std::unique_ptr<StageCase>(const CaseOptions&)>;

/// All sizes, both mappings; the whole picture on sixteen lanes only, since its oracle takes longest.
inline void checkSizes(const CaseMaker& make) {
  unsigned seed = 100;
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const Size size : testSizes()) {
      if (mapping == Mapping::Narrow && size.width == testSizes().back().width) continue;
      CaseOptions options;
      options.size = size;
      options.mapping = mapping;
      options.seed = seed++;
      checkAgreement(*make(options), options);
    }
  }
}

/// These layouts at a size with whole and broken groups of lanes. One pixel a work-item has one path for all
/// layouts, so the last will do there.
inline void checkLayouts(const CaseMaker& make, const std::vector<ImageLayout>& layouts) {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (std::size_t i = 0; i < layouts.size(); ++i) {
      if (mapping == Mapping::Narrow && i + 1 != layouts.size()) continue;
      CaseOptions options;
      options.size = {37, 5};
      options.mapping = mapping;
      options.layout = layouts[i];
      checkAgreement(*make(options), options);
    }
  }
}

/// Leaves out holes of background, with what earlier frames left in them, or antialiases them.
inline void checkHoles(const CaseMaker& make) {
  unsigned seed = 200;
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const Size size : {Size{7, 93}, Size{77, 43}, Size{131, 83}}) {
      for (const Skip skip : {Skip::On, Skip::OnJittered}) {
        CaseOptions options;
        options.size = size;
        options.mapping = mapping;
        options.seed = seed++;
        options.skip = skip;
        const auto stageCase = make(options);
        INFO((skip == Skip::On ? "still" : "jittered"));
        CHECK(stageCase->harness().hasPort("surfaces"));
        checkAgreement(*stageCase, options);
      }
    }
  }
}

/// Variants of a stage, each a kernel of its own: all on sixteen lanes, the last on one.
inline void checkVariants(const std::vector<CaseMaker>& makers) {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (std::size_t i = 0; i < makers.size(); ++i) {
      if (mapping == Mapping::Narrow && i + 1 != makers.size()) continue;
      CaseOptions options;
      options.size = {37, 5};
      options.mapping = mapping;
      INFO("variant " << i);
      checkAgreement(*makers[i](options), options);
    }
  }
}

/// The named buffers have the same bits after runs with the usual work-group, which other tests have compiled already,
/// and with another one, and with one pixel a work-item.
inline void checkWorkGroups(const CaseMaker& make, const std::vector<std::string>& outputs) {
  std::vector<Planes> first;
  CaseOptions options;
  options.size = {77, 43};
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const std::array<int, 2> group : {std::array<int, 2>{0, 0}, std::array<int, 2>{16, 4}}) {
      if (mapping == Mapping::Narrow && group[0] != 0) continue;
      options.mapping = mapping;
      options.workGroup = group;
      const auto stageCase = make(options);
      stageCase->upload();
      stageCase->run();
      for (std::size_t i = 0; i < outputs.size(); ++i) {
        INFO(outputs[i] << " " << describe(options));
        Planes output = stageCase->harness().download(outputs[i]);
        if (first.size() <= i) first.push_back(output);
        CHECK(sameBits(first[i], output));
      }
    }
  }
}

}  // namespace quell::tests
