// The time of one launch of a kernel.
#pragma once

#include <cstddef>

#include "host/core/opencl.hpp"

namespace quell {

/// How often: first untimed, then timed.
struct Repetitions {
  int warmUps;
  int runs;  ///< at least one
};

/// The median of the runs over `items` work-items in groups of `group`, seconds; by events, or by the clock on runtimes
/// whose events carry no times. Blocks.
double medianSeconds(const cl::CommandQueue& queue, const cl::Kernel& kernel, std::size_t items,
                     std::size_t group, Repetitions repetitions);

}  // namespace quell
