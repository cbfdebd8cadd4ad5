#include "bench/copy_bandwidth.hpp"

#include <chrono>
#include <vector>

#include "host/core/cl_error.hpp"
#include "host/core/frame_timer.hpp"

namespace quell {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{256} << 20;
constexpr int kWarmUpRuns = 3;
constexpr int kRuns = 30;
constexpr std::size_t kWorkGroup = 64;
// Bytes of one copy: 1280 x 720 pixels, 3 floats, read and written.
constexpr double kCopyBytes = 1280.0 * 720.0 * 12.0 * 2.0;

constexpr char kSource[] = R"(
__kernel void copy(__global const float4* from, __global float4* to) {
  const size_t i = get_global_id(0);
  to[i] = from[i];
}
)";

double runOnce(const cl::CommandQueue& queue, const cl::Kernel& kernel) {
  cl::Event event;
  const auto start = std::chrono::steady_clock::now();
  queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(kBufferBytes / sizeof(cl_float4)),
                             cl::NDRange(kWorkGroup), nullptr, &event);
  event.wait();
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  if (!FrameTimer::hasDeviceTimes(event)) return wall.count();
  return static_cast<double>(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                             event.getProfilingInfo<CL_PROFILING_COMMAND_START>()) *
         1e-6;
}

CopyBandwidth measure(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue) {
  cl::Program program(context, kSource);
  program.build({device});
  cl::Kernel kernel(program, "copy");
  const cl::Buffer from(context, CL_MEM_READ_WRITE, kBufferBytes);
  const cl::Buffer to(context, CL_MEM_READ_WRITE, kBufferBytes);
  queue.enqueueFillBuffer(from, cl_float(1.0f), 0, kBufferBytes);
  kernel.setArg(0, from);
  kernel.setArg(1, to);
  for (int i = 0; i < kWarmUpRuns; ++i) runOnce(queue, kernel);
  std::vector<double> samplesMs;
  for (int i = 0; i < kRuns; ++i) samplesMs.push_back(runOnce(queue, kernel));
  const double bytesPerMs = 2.0 * static_cast<double>(kBufferBytes) / summarise(samplesMs).medianMs;
  return {bytesPerMs * 1e-6, kCopyBytes / bytesPerMs};
}

}  // namespace

CopyBandwidth measureCopyBandwidth(cl_context context, cl_device_id device, cl_command_queue queue) {
  return withClErrors("copy bandwidth", [&] {
    return measure(cl::Context(context, true), cl::Device(device, true), cl::CommandQueue(queue, true));
  });
}

}  // namespace quell
