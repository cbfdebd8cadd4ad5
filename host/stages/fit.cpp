#include "host/stages/fit.hpp"

#include <algorithm>
#include <cmath>
#include <quell/error.hpp>

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

const cl::Buffer& materialsOf(const FrameRun& run, const FitFeatures& features) {
  return run.buffer(features.needMaterial() ? "materials" : "guides");
}

std::size_t Fit::recordElements(Size size, const FitFeatures& features) {
  return static_cast<std::size_t>(blockCount(size)) * static_cast<std::size_t>(features.recordSize());
}

std::size_t Fit::storageElements(Size size, FeatureStorage storage, const FitFeatures& features) {
  if (storage == FeatureStorage::Float) return 1;
  const auto columns = static_cast<std::size_t>(features.count() + QUELL_FIT_CHANNELS);
  return static_cast<std::size_t>(blockCount(size)) * columns * QUELL_BLOCK_PIXELS / 2;
}

std::string signalOptions(int signal) { return "-D QUELL_SIGNAL=" + std::to_string(signal) + " "; }

std::string signalLabel(int signal) {
  return signal == 0 ? "" : " (signal " + std::to_string(signal + 1) + ")";
}

void Fit::build(const KernelBuilder& builder) {
  const Configuration& configuration = builder.configuration();
  const auto lanes = static_cast<std::size_t>(configuration.device.lanes);
  // 256 logical lanes are shared out, so lanes and work-items together must not exceed them; the pivot of each of up to
  // 16 features comes from a lane of its own, so they must not be fewer either.
  const std::size_t least = std::max<std::size_t>(1, QUELL_MOST_FEATURES / lanes);
  m_groupSize = std::min(builder.groupSize(configuration.options.fitGroup, lanes > 1 ? 1 : kGpuGroup),
                         kGpuGroup / lanes);
  m_groupSize = std::max(m_groupSize, least);
  for (;; m_groupSize /= 2) {
    m_kernel =
        builder.build("fit", m_features.options() + signalOptions(m_signal) +
                                 "-D FIT_GROUP_SIZE=" + std::to_string(m_groupSize) +
                                 " -D FIT_STORAGE_HALF=" + (m_storage == FeatureStorage::Half ? "1" : "0") +
                                 " -D FIT_UNROLL=" + (configuration.device.isCpu ? "0" : "1"));
    if (builder.maxWorkGroup(m_kernel) >= m_groupSize) break;
    if (m_groupSize == least)
      throw Error(ErrorCode::BuildFailed, {"fit", "work-group", std::to_string(least) + " work-items or more",
                                           std::to_string(builder.maxWorkGroup(m_kernel))});
  }
}

void Fit::enqueue(FrameRun& run) {
  const Size size = run.configuration.size();
  FitParams params = makeFitParams(size, run.frameIndex, m_noiseAmplitude);
  params.viewAxis = run.reprojection.viewDepth;
  const std::size_t items = static_cast<std::size_t>(blockCount(size)) * m_groupSize;
  run.launch(m_kernel, {items, 1}, cl::NDRange(m_groupSize, 1), run.buffer("irradiance"),
             run.buffer("guides"), materialsOf(run, m_features), run.buffer("fitRecords"),
             run.buffer("fitStorage"), params);
}

}  // namespace quell
