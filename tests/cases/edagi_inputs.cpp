#include "tests/cases/edagi_inputs.hpp"

namespace quell::tests {

StageSetup makeEdagiSetup(const CaseOptions& options, const EdagiVariant& variant) {
  StageSetup setup = makeSetup(options);
  setup.frame.radiance = makeView(packed(3), setup.size);
  if (variant.signals == 2) setup.frame.glossyRadiance = makeView(packed(3), setup.size);
  if (variant.roughness) setup.frame.roughness = makeView(packed(1), setup.size);
  if (variant.hitDistance) setup.frame.hitDistance = makeView(packed(1), setup.size);
  setup.settings = Settings("edagi");
  for (const auto& [name, value] : {std::pair{"depthSigma", 1.5},
                                    {"normalPower", 100.0},
                                    {"hysteresis", 0.9},
                                    {"nearFootprints", 3.0},
                                    {"farFootprints", 6.0},
                                    {"clampSigma", 1.5},
                                    {"historyRadiusShare", 0.04},
                                    {"radiusShare", 0.1},
                                    {"lowConfidenceFactor", 3.0},
                                    {"glossySigma", 5.0}})
    setup.settings.set(name, value);
  return setup;
}

}  // namespace quell::tests
