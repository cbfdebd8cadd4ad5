// What the device's memory can do at best: the yardstick for all kernels.
#pragma once

#include <CL/cl.h>

#include <vector>

namespace quell {

/// Bytes of one *copy*, the unit in which stage times are comparable between devices: an image of 1280x720
/// with 24 bytes a pixel (float3 in, float3 out).
constexpr double kCopyBytes = 1280.0 * 720.0 * 24.0;

struct CopyBandwidth {
  double gigabytesPerSecond = 0.0;  ///< 1e9 bytes read or written per second
  double copyMs = 0.0;              ///< time of one copy at this bandwidth
};

/// Copies between two buffers of 256 MiB (less where the device allows no such buffers), float4 by float4:
/// the median of 30 runs after a warm-up. The queue needs CL_QUEUE_PROFILING_ENABLE and should be idle.
/// Throws quell::Error.
CopyBandwidth measureCopyBandwidth(cl_context context, cl_device_id device, cl_command_queue queue);

/// Of the times of a copy; at least one measurement.
CopyBandwidth mean(const std::vector<CopyBandwidth>& measurements);

}  // namespace quell
