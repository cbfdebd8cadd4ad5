// Settings of the method atrous.
#pragma once

#include "host/methods/common_settings.hpp"

namespace quell {

struct AtrousSettings {
  int iterations;
  double luminanceSigma;
  EdgeStops stops;
  bool skip;
  Demodulation demodulate;
  DisplayTransform display;
};

inline SettingTable<AtrousSettings> atrousSettings() {
  using S = AtrousSettings;
  SettingTable<S> table;
  addIterations(table, &S::iterations);
  table.add(
      "luminanceSigma", &S::luminanceSigma, 4.0, {0.01, 1e6, "luminance"},
      "difference in luminance at which a tap's weight falls to 1/e; halves with every iteration",
      "Dammertz et al. 2010, section 3 (halving); sweep over four rendered sequences, docs/svgf-sweep.md");
  table.include(&S::stops, edgeStopSettings());
  addSkip(table, &S::skip);
  addDemodulation(table, &S::demodulate);
  table.include(&S::display, displaySettings());
  return table;
}

/// There is no history to discard.
inline RuntimeSettings runtimeSettings(const AtrousSettings& s) { return {s.demodulate, {}, s.display}; }

}  // namespace quell
