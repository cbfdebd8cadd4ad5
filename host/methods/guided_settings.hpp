// Settings of the method guided.
#pragma once

#include "host/methods/common_settings.hpp"

namespace quell {

struct GuidedSettings {
  double irradianceLeastWeight;
  double fireflyRatio;
  int radius;       ///< pixels
  double epsilon;   ///< guide units squared
  int subsampling;  ///< pixels
  CommonSettings common;
};

inline SettingTable<GuidedSettings> guidedSettings() {
  using S = GuidedSettings;
  SettingTable<S> table;
  table
      .add("irradianceLeastWeight", &S::irradianceLeastWeight, 0.35, {0.001, 1.0},
           "least weight of the newest sample",
           "sweep over four rendered sequences, docs/guided-sweep.md; Koskela et al. 2019, phase I (0.2)")
      .paper(0.2);
  addFireflyRatio(table, &S::fireflyRatio).paper(0.0);
  table
      .add("radius", &S::radius, 4, {1, 64, "pixels"},
           "windows reach so far to either side, rounded to whole cells",
           "sweep, docs/guided-sweep.md; Koskela et al. 2019, section 6.2: 12 for direct light, 24 for "
           "indirect")
      .paper(12);
  table
      .add("epsilon", &S::epsilon, 0.001,
           {1e-4, 10.0, "squared units of the normal, squared shares of depth"},
           "added to the variance of the guides: what varies less is smoothed",
           "sweep, docs/guided-sweep.md; Bauszat et al. 2011, as Koskela et al. 2019, section 6.2, have it "
           "(0.01)")
      .paper(0.01);
  table
      .addOneOf("subsampling", &S::subsampling, {2, 1, 4, 8}, "pixels",
                "edge of the cells whose coefficients are computed; 1: those of every pixel, as published",
                "He and Sun 2015, who take 4; sweep, docs/guided-sweep.md")
      .paper(1);  // the second choice, which is 1, too
  table.include(&S::common, commonSettings());
  return table;
}

}  // namespace quell
