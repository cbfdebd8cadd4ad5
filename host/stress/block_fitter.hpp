// Runs blocks through the stages that denoise them: accumulate_noisy, then either solver, then weighted_sum.
#pragma once

#include <cstdint>
#include <memory>
#include <quell/denoiser.hpp>
#include <string>
#include <vector>

#include "host/stress/block.hpp"
#include "kernels/common/guides.h"
#include "kernels/fit_params.h"

namespace quell::stress {

/// householder: stage fit. gram: stages gram_sums and gram_solve with blocks for windows.
enum class Solver { Householder, Gram };
constexpr Solver kSolvers[] = {Solver::Householder, Solver::Gram};
std::string solverName(Solver solver);

constexpr int kGuidePlanes = QUELL_GUIDE_PLANES_OF(1);

/// One block as the solvers see it, behind the checks and clamps of accumulate_noisy.
struct BlockInputs {
  std::array<std::array<float, 3>, kBlockPixels> irradiance{};
  std::array<std::array<float, kGuidePlanes>, kBlockPixels> guides{};
};

/// What a solver makes of one block.
struct BlockFit {
  std::array<float, QUELL_FIT_RECORD> record{};             ///< see fit_params.h
  std::array<std::array<float, 3>, kBlockPixels> fitted{};  ///< of weighted_sum
};

struct BatchFit {
  std::vector<BlockInputs> inputs;
  std::vector<BlockFit> householder, gram;

  const std::vector<BlockFit>& of(Solver solver) const { return solver == Solver::Gram ? gram : householder; }
};

struct FitterOptions {
  std::string device;            ///< as for chooseDevice()
  Options options;               ///< mapping, fitGroup and cacheDirectory count
  double noiseAmplitude = 0.01;  ///< epsilon of the regularisation (Koskela et al. 2019, phase II)
};

/// Every block is a block of the grid: nothing is displaced or mirrored, and no pixel has a history.
class BlockFitter {
 public:
  /// Throws quell::Error if there is no such device or a kernel cannot be built.
  explicit BlockFitter(const FitterOptions& options);
  ~BlockFitter();

  /// `noiseSeed` + index of the block: seed of its stochastic regularisation. Throws quell::Error.
  BatchFit fit(const Batch& batch, std::uint32_t noiseSeed);

  /// Name of the device.
  const std::string& deviceName() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

}  // namespace quell::stress
