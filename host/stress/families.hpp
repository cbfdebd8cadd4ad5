// The families of the stress suite: what is wrong with their blocks, and what a fit may be held to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/stress/block.hpp"
#include "host/stress/random.hpp"

namespace quell::stress {

enum class Posedness {
  Well,  ///< the data decide the prediction: our residual must come close to the least there is
  Ill,   ///< directions of the features carry next to no data: the prediction must only stay plausible
};

struct Family {
  std::string name;
  Posedness posedness;
  /// Fills one block, which is empty (all sky, black).
  void (*makeBlock)(Block& block, Random& random);
  /// Sets what all blocks of a batch share; may be null.
  void (*prepare)(Batch& batch, Random& random) = nullptr;
};

/// All families in the order of the table.
const std::vector<Family>& families();

/// `count` blocks of a family under one camera; equal arguments give equal blocks.
Batch makeBatch(const Family& family, std::uint32_t seed, std::uint32_t batchIndex, int count);

}  // namespace quell::stress
