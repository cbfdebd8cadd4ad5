// Which kernels a configuration is made of, without compiling any: for offline compilers and their reports.
#pragma once

#include <vector>

#include "host/core/kernel_uses.hpp"

namespace quell::cli {

/// What the stages compile for this configuration, in their order, repeated where stages repeat; its `runtime` is made
/// here. No OpenCL device is needed. Throws what prepare() would throw for settings that do not go together.
std::vector<KernelUse> listKernels(Configuration configuration);

}  // namespace quell::cli
