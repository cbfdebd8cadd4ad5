// What the device's arithmetic can do at best: the other side of the roofline.
#pragma once

#include <CL/cl.h>

namespace quell {

/// Floating-point operations per second, 1e9 each, of independent chains of multiply-adds in single precision, a
/// multiply-add counted as two; the best of scalar and sixteen-wide work-items, each the median of several runs
/// after a warm-up. The queue needs CL_QUEUE_PROFILING_ENABLE and should be idle. Throws quell::Error.
double measureFmaRate(cl_context context, cl_device_id device, cl_command_queue queue);

}  // namespace quell
