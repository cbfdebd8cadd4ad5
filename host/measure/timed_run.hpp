// The time of one launch of a kernel.
#pragma once

#include <cstddef>

#include "host/core/opencl.hpp"

namespace quell {

/// Seconds of one run over `items` work-items in groups of `group`, by events, or by the clock on runtimes whose
/// events carry no times. Blocks.
double timedRun(const cl::CommandQueue& queue, const cl::Kernel& kernel, std::size_t items,
                std::size_t group);

}  // namespace quell
