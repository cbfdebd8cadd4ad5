#include "host/stages/fit.hpp"

#include <algorithm>
#include <cmath>
#include <quell/error.hpp>

#include "host/stages/fit_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {
namespace {

// Work-items per block on GPUs: with 256 every work-item keeps four rows of all columns in registers.
constexpr std::size_t kGpuGroup = 256;
// Offsets of the block grid repeat after this many frames (Koskela et al. 2019, reference implementation).
constexpr std::uint32_t kBlockOffsets = 16;
// Steps of the two-dimensional additive recurrence with the least discrepancy, 1/g and 1/g^2 with g^3 = g + 1
// (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences"): spreads the offsets evenly.
constexpr double kOffsetStepX = 0.7548776662466927;
constexpr double kOffsetStepY = 0.5698402909980532;

int blocksAlong(int pixels) { return (pixels + QUELL_BLOCK_EDGE - 1) / QUELL_BLOCK_EDGE + 1; }

// In [-32, -1]: the first block always covers pixel 0 and one more block than fits is always enough.
int offsetAlong(std::uint32_t frameIndex, double step) {
  const double position = 0.5 + step * (frameIndex % kBlockOffsets);
  return static_cast<int>((position - std::floor(position)) * QUELL_BLOCK_EDGE) - QUELL_BLOCK_EDGE;
}

}  // namespace

QUELL_PORTS(FitOptions, FIT)

int blockCount(Size size) { return blocksAlong(size.width) * blocksAlong(size.height); }

FitParams makeFitParams(Size size, std::uint32_t frameIndex, double noiseAmplitude) {
  FitParams params{};
  params.planes = makePlanes(size);
  params.blockOffsetX = offsetAlong(frameIndex, kOffsetStepX);
  params.blockOffsetY = offsetAlong(frameIndex, kOffsetStepY);
  params.blocksX = blocksAlong(size.width);
  params.blocksY = blocksAlong(size.height);
  params.noiseSeed = frameIndex * static_cast<std::uint32_t>(blockCount(size));
  params.noiseAmplitude = static_cast<float>(noiseAmplitude);
  return params;
}

int fitRecordFloats(Size size, const FitFeatures& features) {
  return blockCount(size) * features.recordSize();
}

Fit::Fit(const Configuration& configuration, const FitFeatures& features, const Setup& setup)
    : m_setup(setup), m_features(features) {
  setFitOptions<FitOptions>(*this, configuration, features, setup.signal, setup.skip);
  TAP_WEIGHTS = setup.tapWeights ? 1 : 0;
  FIT_STORAGE_HALF = setup.storage == FeatureStorage::Half ? 1 : 0;
  FIT_UNROLL = configuration.device.isCpu ? 0 : 1;
  recordFloats = fitRecordFloats(configuration.size(), features);
  storageHalves = std::int64_t{blockCount(configuration.size())} * (features.count() + QUELL_FIT_CHANNELS) *
                  QUELL_BLOCK_PIXELS;
}

void Fit::build(const KernelBuilder& builder) {
  const Configuration& configuration = builder.configuration();
  const auto lanes = static_cast<std::size_t>(configuration.device.lanes);
  // 256 logical lanes are shared out, so lanes and work-items together must not exceed them. On GPUs the pivot of each of
  // up to 16 features comes from a register of another work-item, so there must not be fewer either.
  const std::size_t least = lanes > 1 ? 1 : QUELL_MOST_FEATURES;
  std::size_t group = std::min(builder.groupSize(configuration.options.fitGroup, lanes > 1 ? 1 : kGpuGroup),
                               kGpuGroup / lanes);
  group = std::max(group, least);
  for (;; group /= 2) {
    GROUP_SIZE = static_cast<int>(group);
    KernelStage::build(builder);
    if (builder.maxWorkGroup(m_kernel) >= group) break;
    if (group == least)
      throw Error(ErrorCode::BuildFailed, {"fit", "work-group", std::to_string(least) + " work-items or more",
                                           std::to_string(builder.maxWorkGroup(m_kernel))});
  }
  m_workGroup = cl::NDRange(group, 1);
}

FitParams Fit::params(const FrameRun& run) const {
  FitParams params = makeFitParams(run.frame.size, run.frameIndex, m_setup.noiseAmplitude);
  params.viewAxis = run.reprojection.viewDepth;
  return params;
}

std::array<std::size_t, 2> Fit::range(const FrameRun& run) const {
  const FitParams grid = params(run);
  return {static_cast<std::size_t>(grid.blocksX * grid.blocksY) * m_workGroup[0], 1};
}

}  // namespace quell
