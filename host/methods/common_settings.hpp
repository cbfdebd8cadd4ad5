// Settings that several methods share, written once.
#pragma once

#include <optional>

#include "host/core/runtime_settings.hpp"
#include "host/methods/setting_table.hpp"
#include "host/stages/edge_stops.hpp"

namespace quell {

/// When history is discarded.
struct DiscardSettings {
  double positionLimitFootprints;
  double positionLimit;
  double normalLimitSquared;
};

inline SettingTable<DiscardSettings> discardSettings() {
  using S = DiscardSettings;
  SettingTable<S> table;
  table.add("positionLimitFootprints", &S::positionLimitFootprints, 8.0, {0.0, 1e6, "pixel footprints"},
            "history farther than this from the surface is discarded",
            "sweep over four rendered sequences: flat from 4 to 64");
  table.add("positionLimit", &S::positionLimit, 0.0, {0.0, 1e18, "scene units"},
            "the same limit in scene units, as the paper has it; above 0 it replaces positionLimitFootprints",
            "Koskela et al. 2019, phase I");
  table.add("normalLimitSquared", &S::normalLimitSquared, 0.1, {0.0, 4.0},
            "history whose unit normal differs by more (squared length of the difference) is discarded",
            "reference implementation; a sweep from 0.03 to 1 changes the error by 1 %");
  return table;
}

inline DiscardLimits discardLimits(const DiscardSettings& s) {
  return {s.positionLimit, s.positionLimit > 0.0 ? 0.0 : s.positionLimitFootprints, s.normalLimitSquared};
}

struct AntialiasingSettings {
  bool taa = false;
  double taaNewestWeight = 0.0, taaJitteredWeight = 0.0, taaSilhouetteWeight = 0.0;
  bool antialiasLinear = false;
  bool jitteredRays = false;
};

inline SettingTable<AntialiasingSettings> antialiasingSettings() {
  using S = AntialiasingSettings;
  SettingTable<S> table;
  table.add("taa", &S::taa, true, "temporal antialiasing of the display output",
            "Koskela et al. 2019, phase III");
  table.add("taaNewestWeight", &S::taaNewestWeight, 0.5, {0.001, 1.0},
            "weight of the newest frame in temporal antialiasing",
            "Koskela et al. 2019, reference implementation");
  table.add("taaJitteredWeight", &S::taaJitteredWeight, 0.4, {0.001, 1.0},
            "the same where rays are jittered: each frame's texture is one sample's, too",
            "ours, docs/quell-sweep.md");
  table.add("taaSilhouetteWeight", &S::taaSilhouetteWeight, 0.25, {0.001, 1.0},
            "the same where surfaces clearly apart meet", "ours, docs/quell-sweep.md");
  table.add("antialiasLinear", &S::antialiasLinear, false,
            "temporal antialiasing of the linear output as well, as tone maps of one's own need it",
            "ours: antialiasing works in linear radiance");
  table.add("jitteredRays", &S::jitteredRays, false,
            "primary rays are jittered inside their pixels: the linear output is antialiased over time as "
            "well, and "
            "background takes part",
            "ours: each frame's silhouettes are one sample's");
  return table;
}

inline SettingTable<DisplayTransform> displaySettings() {
  using S = DisplayTransform;
  SettingTable<S> table;
  table.add("toneMap", &S::toneMap, ToneMap::Clamp,
            "how the display output brings radiance into [0, 1]: clamped; Reinhard's curve on luminance; a "
            "filmic curve "
            "like that of ACES; none, up to 65504",
            "Reinhard et al. 2002, equation 3; Narkowicz 2015 (aces)");
  table.add("displayEncoding", &S::encoding, DisplayEncoding::Gamma,
            "encoding of the display output after the tone map: gamma 2.2, sRGB, or linear",
            "Koskela et al. 2019, reference implementation; IEC 61966-2-1 (srgb)");
  table.add("exposure", &S::exposure, 0.0, {-32.0, 32.0, "stops"},
            "radiance in the display output is multiplied by 2^exposure before the tone map",
            "a plain factor");
  return table;
}

template <class S>
void addDemodulation(SettingTable<S>& table, Demodulation S::*member) {
  table.add(
      "demodulate", member, Demodulation::Albedo,
      "what light is divided by before it is filtered: nothing, albedo and gloss colour, or these with the "
      "gloss colour times F_beta (needs roughness)",
      "Koskela et al. 2019, section 3; Zhuang et al. 2021, section 4.1 (fbeta)");
}

template <class S>
void addSkip(SettingTable<S>& table, bool S::*member) {
  table.add("skip", member, true, "leave out background, from the first stage to the last",
            "ours, kernels/common/surfaces.h: a frame that is all sky takes a fifth of the time");
}

/// What every method with a history has.
struct CommonSettings {
  bool skip;
  Demodulation demodulate;
  DiscardSettings discard;
  AntialiasingSettings antialiasing;
  DisplayTransform display;
};

inline SettingTable<CommonSettings> commonSettings() {
  using S = CommonSettings;
  SettingTable<S> table;
  addSkip(table, &S::skip);
  addDemodulation(table, &S::demodulate);
  table.include(&S::discard, discardSettings());
  table.include(&S::antialiasing, antialiasingSettings());
  table.include(&S::display, displaySettings());
  return table;
}

/// Of the settings of a method that has these.
template <class S>
RuntimeSettings runtimeSettings(const S& settings) {
  return {settings.common.demodulate, discardLimits(settings.common.discard), settings.common.display};
}

template <class S>
typename SettingTable<S>::Row& addMomentsLeastWeight(SettingTable<S>& table, double S::*member) {
  return table.add("momentsLeastWeight", member, 0.2, {0.001, 1.0},
                   "least weight of the newest sample in the moments of luminance",
                   "Schied et al. 2017, section 4.2");
}

template <class S>
typename SettingTable<S>::Row& addFireflyRatio(SettingTable<S>& table, double S::*member) {
  return table.add(
      "fireflyRatio", member, 4.0, {0.0, 1e6, "luminance of the brightest pixel around"},
      "brightness from which on a pixel whose light comes from one sample has less weight in the "
      "filter; the history keeps it; 0: none has",
      "ours, kernels/common/fireflies.h; docs/quell-sweep.md");
}

template <class S>
typename SettingTable<S>::Row& addKeepLight(SettingTable<S>& table, bool S::*member) {
  return table.add(
      "keepLight", member, true,
      "give back the light that the filter loses, from the means of history and filtered over windows",
      "ours, kernels/light_gain.cl; docs/quell-sweep.md");
}

template <class S>
typename SettingTable<S>::Row& addTemporalVarianceFrames(SettingTable<S>& table, int S::*member,
                                                         int byDefault, const char* source) {
  return table.add("temporalVarianceFrames", member, byDefault, {1, 255, "frames"},
                   "history length from which on the variance over time is trusted", source);
}

/// `least` 0: the method can do without the filter.
template <class S>
typename SettingTable<S>::Row& addIterations(SettingTable<S>& table, int S::*member, int least = 1) {
  return table.add(
      "iterations", member, 5, {double(least), 7},
      least == 0
          ? "iterations of the a-trous filter, the last one's taps 2^(iterations - 1) pixels apart; 0: "
            "none, the output is the history"
          : "iterations of the a-trous filter; the last one's taps are 2^(iterations - 1) pixels apart",
      "Schied et al. 2017, section 4.3");
}

/// `paper`: the values of the method's paper, if that has these stops.
inline SettingTable<EdgeStops> edgeStopSettings(const std::optional<EdgeStops>& paper = {}) {
  using S = EdgeStops;
  constexpr const char* source =
      "Schied et al. 2017, section 4.4; sweep over four rendered sequences, docs/svgf-sweep.md";
  const auto inPaper = [&](double S::*stop) {
    return paper ? std::optional<double>((*paper).*stop) : std::nullopt;
  };
  SettingTable<S> table;
  table
      .add("depthSigma", &S::depthSigma, 4.0, {0.01, 1e3, "steps of the depth's slope"},
           "difference in view depth at which a tap's weight falls to 1/e", source)
      .paper(inPaper(&S::depthSigma));
  table
      .add("normalPower", &S::normalPower, 16.0, {1.0, 1024.0},
           "power of the cosine between the normals of pixel and tap", source)
      .paper(inPaper(&S::normalPower));
  table
      .add("roughnessSigma", &S::roughnessSigma, 0.5, {0.0, 10.0, "relative difference"},
           "difference in roughness at which a tap's weight falls to 1/e; 0, or no roughness image: no such "
           "stop",
           "not in the paper; sweep over four rendered sequences, docs/svgf-sweep.md")
      .paper(inPaper(&S::roughnessSigma));
  return table;
}

}  // namespace quell
