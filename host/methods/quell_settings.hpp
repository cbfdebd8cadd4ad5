// Settings of the method quell.
#pragma once

#include "host/methods/common_settings.hpp"

namespace quell {

struct QuellSettings {
  int historyFrames;
  int stillHistoryFrames;
  double momentsLeastWeight;
  double fireflyRatio;
  int temporalVarianceFrames;
  double mostWeight;
  double changeThreshold;
  double recentChangeThreshold;
  double changeGain;
  double changeMemory;
  int iterations;
  int prefilteredIterations;
  double prefilteredSigma;
  double luminanceSigma;
  EdgeStops stops;
  double sharpRoughness;
  bool keepLight;
  CommonSettings common;
};

inline SettingTable<QuellSettings> quellSettings() {
  using S = QuellSettings;
  constexpr const char* sweep = "sweep, docs/quell-sweep.md";
  SettingTable<S> table;
  table.add("historyFrames", &S::historyFrames, 7, {1, 255, "frames"},
            "longest history of what moves on the screen", sweep);
  table.add("stillHistoryFrames", &S::stillHistoryFrames, 32, {1, 255, "frames"},
            "longest history of what does not move on the screen; at least historyFrames counts", sweep);
  addMomentsLeastWeight(table, &S::momentsLeastWeight);
  addFireflyRatio(table, &S::fireflyRatio);
  addTemporalVarianceFrames(table, &S::temporalVarianceFrames, 3, sweep);
  table.add("mostWeight", &S::mostWeight, 1.0, {0.0, 1.0},
            "largest weight of the newest sample, where the light changes; 0: change is not followed", sweep);
  table.add("changeThreshold", &S::changeThreshold, 3.0, {0.0, 100.0, "standard deviations"},
            "difference between newest samples and history, over tiles, up to which it counts as noise",
            sweep);
  table.add("recentChangeThreshold", &S::recentChangeThreshold, 1.0, {0.0, 100.0, "standard deviations"},
            "the same where light has changed lately; at most changeThreshold counts", sweep);
  table.add("changeGain", &S::changeGain, 4.0, {0.01, 1e6, "variances"},
            "excess of the squared difference over the threshold at which the weight is half of mostWeight",
            sweep);
  table.add("changeMemory", &S::changeMemory, 0.4, {0.0, 0.99},
            "share of the frame before in the differences that are tested", sweep);
  addIterations(table, &S::iterations, 0);
  table.add("prefilteredIterations", &S::prefilteredIterations, 1, {0, 7},
            "first iterations whose stop compares luminance over 3x3 pixels instead of one, with a Gaussian "
            "fall-off",
            sweep);
  table.add("prefilteredSigma", &S::prefilteredSigma, 1.5, {0.01, 1e3, "standard deviations of the mean"},
            "difference in luminance over 3x3 pixels at which a tap's weight falls to 1/e", sweep);
  table.add("luminanceSigma", &S::luminanceSigma, 4.0, {0.01, 1e3, "standard deviations of the mean"},
            "difference in luminance at which a tap's weight falls to 1/e", sweep);
  table.include(&S::stops, edgeStopSettings());
  table.add("sharpRoughness", &S::sharpRoughness, 0.3, {0.0, 1.0},
            "roughness below which luminanceSigma shrinks, to its half at roughness 0; 0, or no roughness "
            "image: nowhere",
            sweep);
  addKeepLight(table, &S::keepLight);
  table.include(&S::common, commonSettings());
  return table;
}

}  // namespace quell
