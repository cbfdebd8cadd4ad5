#include "host/stages/gram_solve.hpp"

#include <algorithm>

// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {
namespace {

// Windows are independent and there are few of them: small groups spread them over all compute units.
constexpr std::size_t kGpuGroup = 64;

}  // namespace

QUELL_PORTS(GramSolveOptions, GRAM_SOLVE)

GramSolve::GramSolve(const Configuration& configuration, const GramWindows& windows, double noiseAmplitude,
                     const FitFeatures& features)
    : m_windows(windows), m_noiseAmplitude(noiseAmplitude), m_features(features) {
  GRAM_OVERLAP = windows.overlap ? 1 : 0;
  tileFloats = gramTileFloats(windows, configuration.size(), features);
  recordFloats = gramRecordFloats(windows, configuration.size(), features);
}

void GramSolve::build(const KernelBuilder& builder) {
  KernelStage::build(builder);
  const bool narrow = builder.configuration().device.lanes == 1;
  m_workGroup = cl::NDRange(narrow ? std::min(kGpuGroup, builder.maxWorkGroup(m_kernel)) : 1, 1);
}

GramParams GramSolve::params(const FrameRun& run) const {
  return makeGramParams(m_windows, run.frame.size, run.frameIndex, m_noiseAmplitude);
}

std::array<std::size_t, 2> GramSolve::range(const FrameRun& run) const {
  const GramParams grid = params(run);
  const int lanes = run.configuration.device.lanes;
  return {static_cast<std::size_t>((grid.tilesX * grid.tilesY + lanes - 1) / lanes), 1};
}

}  // namespace quell
