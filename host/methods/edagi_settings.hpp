// Settings of the method edagi.
#pragma once

#include "host/methods/common_settings.hpp"

namespace quell {

/// How far history is trusted.
struct EdagiHistory {
  double hysteresis;
  bool meanFirst;
  double nearFootprints, farFootprints;
  double nearDistance, farDistance;
  double clampSigma;
};

struct EdagiSettings {
  EdagiHistory history;
  double historyRadiusShare;
  bool suppressFireflies;
  double radiusShare;
  double lowConfidenceFactor;
  double glossySigma;
  EdgeStops stops;
  CommonSettings common;
};

inline SettingTable<EdagiHistory> edagiHistorySettings() {
  using S = EdagiHistory;
  SettingTable<S> table;
  constexpr const char* eq11 = "Mara et al. 2017, section 3.4, eq. (11)";
  table.add("hysteresis", &S::hysteresis, 0.98, {0.0, 0.999}, "most weight of history", eq11).paper(0.98);
  table
      .add("meanFirst", &S::meanFirst, true,
           "history weighs at most as a mean over its frames does, so that the first sample does not outlast "
           "the others",
           "Koskela et al. 2019, phase I; halves the error of 16 frames at rest, and doubles their flicker")
      .paper(false);
  table
      .add("nearFootprints", &S::nearFootprints, 4.0, {0.0, 1e6, "pixel footprints"},
           "history is trusted wholly up to this distance from where it should be",
           "ours, in place of nearDistance; 6 makes no difference")
      .paper(0.0);
  table
      .add("farFootprints", &S::farFootprints, 8.0, {0.0, 1e6, "pixel footprints"},
           "and not at all from this distance on; more than nearFootprints",
           "ours, in place of farDistance: as positionLimitFootprints")
      .paper(0.0);
  table
      .add("nearDistance", &S::nearDistance, 0.0, {0.0, 1e18, "scene units"}, "added to nearFootprints", eq11)
      .paper(0.05);
  table.add("farDistance", &S::farDistance, 0.0, {0.0, 1e18, "scene units"}, "added to farFootprints", eq11)
      .paper(0.07);
  table
      .add("clampSigma", &S::clampSigma, 0.0, {0.0, 1e6, "standard deviations"},
           "how far history may lie off the mean of the newest samples in the 3x3 pixels around; 0: any "
           "distance",
           "Mara et al. 2017, section 3.4, who clamp to the distribution (1)")
      .paper(1.0);
  return table;
}

inline SettingTable<EdagiSettings> edagiSettings() {
  using S = EdagiSettings;
  SettingTable<S> table;
  table.include(&S::history, edagiHistorySettings());
  table
      .add("historyRadiusShare", &S::historyRadiusShare, 0.003, {1e-4, 0.1, "of the image's width"},
           "radius of the disc whose mean goes into the history",
           "sweep, docs/edagi-sweep.md; Mara et al. 2017, section 3.4: a diameter of 1 %")
      .paper(0.005);
  table
      .add("suppressFireflies", &S::suppressFireflies, true, "median of 3x3 pixels of what is shown",
           "Mara et al. 2017, stage 6")
      .paper(true);
  table
      .add("radiusShare", &S::radiusShare, 0.005, {1e-3, 0.5, "of the image's width"},
           "radius of the last filter where history is not trusted",
           "sweep, docs/edagi-sweep.md; Mara et al. 2017, section 3.4: a twentieth")
      .paper(0.05);
  table
      .add("lowConfidenceFactor", &S::lowConfidenceFactor, 3.0, {1.0, 100.0},
           "the radius is so many times larger where less than half of the history is trusted",
           "sweep, docs/edagi-sweep.md; Mara et al. 2017, section 3.4 (6)")
      .paper(6.0);
  table
      .add("glossySigma", &S::glossySigma, 2.0, {0.01, 14.0, "pixels"},
           "deviation of the glossy filter at roughness 1; follows its tenth root",
           "sweep, docs/edagi-sweep.md; Mara et al. 2017, section 3.4 (7)")
      .paper(7.0);
  table.include(&S::stops, edgeStopSettings());
  table.include(&S::common, commonSettings());
  return table;
}

}  // namespace quell
