// Settings of the method svgf, and their values in its paper.
#pragma once

#include "host/methods/common_settings.hpp"

namespace quell {

/// What becomes the history.
enum class Feedback { First, None };
constexpr std::array<const char*, 2> choiceNames(Feedback) { return {"first", "none"}; }

struct SvgfSettings {
  double irradianceLeastWeight;
  double momentsLeastWeight;
  Feedback feedback;
  double fireflyRatio;
  int temporalVarianceFrames;
  int iterations;
  double luminanceSigma;
  EdgeStops stops;
  bool keepLight;
  CommonSettings common;
};

inline SettingTable<SvgfSettings> svgfSettings() {
  using S = SvgfSettings;
  SettingTable<S> table;
  table
      .add("irradianceLeastWeight", &S::irradianceLeastWeight, 0.46, {0.001, 1.0},
           "least weight of the newest sample",
           "Schied et al. 2017, section 4.1; sweep over four rendered sequences, docs/svgf-sweep.md")
      .paper(0.2);
  addMomentsLeastWeight(table, &S::momentsLeastWeight).paper(0.2);
  table
      .add("feedback", &S::feedback, Feedback::None,
           "what becomes the history: the first iteration's output or the unfiltered mean",
           "Schied et al. 2017, section 4.3 (first); sweep over four rendered sequences, docs/svgf-sweep.md")
      .paper(Feedback::First);
  addFireflyRatio(table, &S::fireflyRatio).paper(0.0);
  addTemporalVarianceFrames(table, &S::temporalVarianceFrames, 4, "Schied et al. 2017, section 4.2").paper(4);
  addIterations(table, &S::iterations).paper(5);
  table
      .add("luminanceSigma", &S::luminanceSigma, 3.5, {0.01, 1e3, "standard deviations"},
           "difference in luminance at which a tap's weight falls to 1/e",
           "Schied et al. 2017, section 4.4; sweep over four rendered sequences, docs/svgf-sweep.md")
      .paper(4.0);
  table.include(&S::stops, edgeStopSettings(EdgeStops{128.0, 1.0, 0.0}));
  addKeepLight(table, &S::keepLight).paper(false);
  table.include(&S::common, commonSettings());
  return table;
}

}  // namespace quell
