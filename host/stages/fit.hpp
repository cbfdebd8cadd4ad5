// Host side of the stage fit, and the block grid that it shares with weighted_sum.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/fit_options.hpp"
#include "kernels/fit_ports.h"

namespace quell {

/// How the columns of the least-squares matrix are stored while a block is factorised.
enum class FeatureStorage {
  Float,  ///< float, in private memory
  Half,   ///< half, block after block in global memory, as in the reference implementation
};
constexpr std::array<const char*, 2> choiceNames(FeatureStorage) { return {"float", "half"}; }

/// Blocks that cover an image of this size at any of the 16 offsets.
int blockCount(Size size);

/// The displaced block grid of one frame. Koskela et al. 2019, phase III: "displaced with random offsets".
FitParams makeFitParams(Size size, std::uint32_t frameIndex, double noiseAmplitude);

/// Floats of the buffer fitRecords of the stage fit.
int fitRecordFloats(Size size, const FitFeatures& features);

QUELL_OPTIONS(FitOptions, FIT, "fit")

/// See kernels/fit.cl for what it computes, from what and after which paper.
class Fit : public KernelStage<FitOptions, FitParams> {
 public:
  struct Setup {
    double noiseAmplitude = 0.01;  ///< epsilon of the stochastic regularisation, scaled feature units, >= 0
    FeatureStorage storage = FeatureStorage::Float;
    int signal = 0;           ///< the one that is fitted, 0 or 1
    bool tapWeights = false;  ///< weights of the stage firefly_weights
    bool skip = false;        ///< leaves out blocks of background (where one work-item has a block)
  };
  Fit(const Configuration& configuration, const FitFeatures& features, const Setup& setup);
  std::string label() const override { return name() + signalLabel(m_setup.signal); }
  void build(const KernelBuilder& builder) override;

 protected:
  FitParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override;
  std::string textDefines() const override { return m_features.options(); }

 private:
  Setup m_setup;
  FitFeatures m_features;
};

}  // namespace quell
