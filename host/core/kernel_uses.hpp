// Which kernels stages are made of, without compiling any.
#pragma once

#include <functional>
#include <vector>

#include "host/core/stage.hpp"

namespace quell {

/// What the stage asks its builder for; the stage cannot run afterwards. Needs no device.
std::vector<KernelUse> kernelUses(Stage& stage, const Configuration& configuration);
/// The same of whatever builds kernels.
std::vector<KernelUse> kernelUses(const std::function<void(const KernelBuilder&)>& build,
                                  const Configuration& configuration);

}  // namespace quell
