// The yardstick of all speed figures: how fast the device copies memory.
#pragma once

#include <CL/cl.h>

namespace quell {

/// The unit *copy* is the time in which a packed float3 frame of 1280x720 is read and written (22.1 MB) at
/// the measured bandwidth.
struct CopyBandwidth {
  double gigabytesPerSecond = 0.0;  ///< 1e9 bytes read and written per second
  double copyMs = 0.0;              ///< milliseconds of one copy
};

/// Median of 30 runs, after warm-up, of a float4 copy kernel between two buffers of 256 MiB (smaller ones
/// would sit in cache). Event times where the queue and runtime give them, else the host's clock. Throws
/// Error(DeviceError | OutOfMemory).
CopyBandwidth measureCopyBandwidth(cl_context context, cl_device_id device, cl_command_queue queue);

}  // namespace quell
