#include "host/methods/common_settings.hpp"

namespace quell {

using Kind = SettingKind;

SettingList joined(std::initializer_list<SettingList> lists) {
  SettingList all;
  for (const SettingList& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

SettingList demodulationSettings() {
  return {
      {"demodulate",
       Kind::Choice,
       1.0,
       0.0,
       2.0,
       "",
       "what light is divided by before it is filtered: nothing, albedo and gloss colour, or these with the "
       "gloss colour times F_beta (needs roughness)",
       "Koskela et al. 2019, section 3; Zhuang et al. 2021, section 4.1 (fbeta)",
       {"none", "albedo", "fbeta"}}};
}

SettingList discardSettings() {
  return {{"positionLimitFootprints",
           Kind::Real,
           8.0,
           0.0,
           1e6,
           "pixel footprints",
           "history farther than this from the surface is discarded",
           "sweep over four rendered sequences: flat from 4 to 64",
           {}},
          {"positionLimit",
           Kind::Real,
           0.0,
           0.0,
           1e18,
           "scene units",
           "the same limit in scene units, as the paper has it; above 0 it replaces positionLimitFootprints",
           "Koskela et al. 2019, phase I",
           {}},
          {"normalLimitSquared",
           Kind::Real,
           0.1,
           0.0,
           4.0,
           "",
           "history whose unit normal differs by more (squared length of the difference) is discarded",
           "reference implementation; a sweep from 0.03 to 1 changes the error by 1 %",
           {}}};
}

DiscardLimits discardLimits(const Settings& s) {
  const double fixed = s.get("positionLimit");
  return {fixed, fixed > 0.0 ? 0.0 : s.get("positionLimitFootprints"), s.get("normalLimitSquared")};
}

SettingList antialiasingSettings() {
  return {{"taa",
           Kind::Boolean,
           1.0,
           0.0,
           1.0,
           "",
           "temporal antialiasing of the display output",
           "Koskela et al. 2019, phase III",
           {}},
          {"taaNewestWeight",
           Kind::Real,
           0.2,
           0.001,
           1.0,
           "",
           "weight of the newest frame in temporal antialiasing",
           "Koskela et al. 2019, reference implementation",
           {}}};
}

SettingList atrousSettings(const SettingDescription& luminanceSigma) {
  return {
      {"iterations",
       Kind::Integer,
       5.0,
       1.0,
       7.0,
       "",
       "iterations of the a-trous filter; the last one's taps are 2^(iterations - 1) pixels apart",
       "Schied et al. 2017, section 4.3",
       {},
       "",
       5.0},
      luminanceSigma,
      {"depthSigma",
       Kind::Real,
       4.0,
       0.01,
       1e3,
       "steps of the depth's slope",
       "difference in view depth at which a tap's weight falls to 1/e",
       "Schied et al. 2017, section 4.4; sweep over four rendered sequences, docs/svgf-sweep.md",
       {},
       "",
       1.0},
      {"normalPower",
       Kind::Real,
       16.0,
       1.0,
       1024.0,
       "",
       "power of the cosine between the normals of pixel and tap",
       "Schied et al. 2017, section 4.4; sweep over four rendered sequences, docs/svgf-sweep.md",
       {},
       "",
       128.0},
      {"roughnessSigma",
       Kind::Real,
       0.5,
       0.0,
       10.0,
       "relative difference",
       "difference in roughness at which a tap's weight falls to 1/e; 0, or no roughness image: no such stop",
       "not in the paper; sweep over four rendered sequences, docs/svgf-sweep.md",
       {},
       "",
       0.0}};
}

EdgeStops edgeStops(const Settings& s) {
  return {s.get("normalPower"), s.get("depthSigma"), s.get("roughnessSigma")};
}

}  // namespace quell
