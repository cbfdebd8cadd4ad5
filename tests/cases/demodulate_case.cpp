#include "tests/cases/demodulate_case.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/f_beta_texels.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

StageSetup makeDemodulateSetup(const CaseOptions& options, const FrameVariant& variant) {
  StageSetup setup = makeSetup(options);
  setup.settings = Settings("atrous");
  setFrameViews(setup, variant, options.layout);
  return setup;
}

// The table between its texels, plainly.
FBetaTerms lookUp(double cosine, double roughness) {
  const FBetaTexels& texels = sharedFBetaTexels(Mapping::Wide, Shadowing::Separable);
  const double u = std::sqrt(cosine) * (kFBetaEdge - 1), v = roughness * (kFBetaEdge - 1);
  const int x = std::min(int(u), kFBetaEdge - 2), y = std::min(int(v), kFBetaEdge - 2);
  FBetaTerms sum;
  for (int tap = 0; tap < 4; ++tap) {
    const int right = tap % 2, down = tap / 2;
    const double weight = (right ? u - x : 1.0 - (u - x)) * (down ? v - y : 1.0 - (v - y));
    const FBetaTerms texel = texels.at(x + right, y + down);
    sum.scale += weight * texel.scale;
    sum.bias += weight * texel.bias;
  }
  return sum;
}

void compareFBeta(Comparison& comparison, const FrameImages& frame, const Planes& device) {
  forEachPixel(device.size(), [&](int x, int y) {
    bool undecided = false;
    const Surface surface = surfaceAt(frame, x, y, undecided);
    if (undecided || !surface.valid) return;
    const FBetaTerms terms = lookUp(cosineOf(surface), roughnessAt(frame, x, y));
    const Vector3d f0 = f0At(frame, x, y);
    for (int c = 0; c < 3; ++c) {
      // As a share of what is allowed, brought to the measure of the other outputs.
      const double share = std::abs(device.at(c, x, y) - f0[c] * terms.scale - terms.bias) / kFBetaTolerance;
      comparison.include("fBeta error", c, x, y, share <= 1.0 ? 0.0 : share, 0.0);
    }
  });
}

}  // namespace

DemodulateCase::DemodulateCase(const CaseOptions& options, const FrameVariant& variant)
    : StageCase("demodulate", makeDemodulateSetup(options, variant)), inputs(randomFrame(variant, options)) {
  inputs.reprojection = makeReprojection({}, {}, options.size);
  m_reprojection = inputs.reprojection;
}

void DemodulateCase::upload() { uploadFrame(m_harness, inputs); }

Comparison DemodulateCase::compare() {
  Comparison comparison(leftOut());
  if (m_harness.hasPort("fBeta")) {
    inputs.material.fBeta = m_harness.download("fBeta");
    compareFBeta(comparison, inputs, inputs.material.fBeta);
  }
  const DemodulateExact exact = demodulateOracle(inputs);
  comparison.exclude(exact.undecided);
  comparePixels(comparison, "irradiance", irradiance(), exact.irradiance, &exact.undecided, nullptr,
                lightUnit());
  comparePixels(comparison, "guides", guides(), exact.guides, &exact.undecided);
  comparePixels(comparison, "viewDepth", m_harness.download("viewDepth"), exact.viewDepth, &exact.undecided);
  if (!inputs.roughness.empty())
    comparePixels(comparison, "roughness", m_harness.download("roughness"), exact.roughness,
                  &exact.undecided);
  return comparison;
}

}  // namespace quell::tests
