// Host side of the stage fit, and the block grid that it shares with weighted_sum.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/fit_features.hpp"
#include "kernels/fit_params.h"

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

/// Compile options of stages that work on one signal at a time.
std::string signalOptions(int signal);
/// What such a stage's label ends with: nothing for the first signal.
std::string signalLabel(int signal);

/// Buffer behind the materials of a fit: the guides stand in where no feature needs any.
const cl::Buffer& materialsOf(const FrameRun& run, const FitFeatures& features);

/// See kernels/fit.cl for what it computes, from what and after which paper.
class Fit : public Stage {
 public:
  /// `noiseAmplitude`: epsilon of the stochastic regularisation, scaled feature units, >= 0.
  /// `signal`: the one that is fitted, 0 or 1.
  Fit(double noiseAmplitude, FeatureStorage storage, const FitFeatures& features, int signal)
      : m_noiseAmplitude(noiseAmplitude), m_storage(storage), m_features(features), m_signal(signal) {}
  std::string name() const override { return "fit"; }
  std::string label() const override { return name() + signalLabel(m_signal); }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration&) const override { return 0; }

  /// Elements of the buffer "fitRecords", and of "fitStorage" (floats holding two halves each; 1 if unused).
  static std::size_t recordElements(Size size, const FitFeatures& features);
  static std::size_t storageElements(Size size, FeatureStorage storage, const FitFeatures& features);

 private:
  double m_noiseAmplitude;
  FeatureStorage m_storage;
  FitFeatures m_features;
  int m_signal;
  std::size_t m_groupSize = 1;
  cl::Kernel m_kernel;
};

}  // namespace quell
