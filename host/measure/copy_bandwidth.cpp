#include "host/measure/copy_bandwidth.hpp"

#include <algorithm>

#include "host/core/cl_error.hpp"
#include "host/measure/timed_run.hpp"

namespace quell {
namespace {

constexpr char kSource[] =
    "__kernel void copy(__global const float4* from, __global float4* to) {\n"
    "  to[get_global_id(0)] = from[get_global_id(0)];\n"
    "}\n";

constexpr std::size_t kBufferBytes = std::size_t(256) << 20;
constexpr std::size_t kVectorBytes = 16;
// Work-items of a group: coalesced on GPUs, and a loop long enough to vectorise on CPUs.
constexpr std::size_t kWorkGroup = 256;
constexpr int kWarmUps = 3;
constexpr int kRuns = 30;

// A multiple of the work-group's bytes that the device can allocate twice.
std::size_t bufferBytes(const cl::Device& device) {
  const std::size_t most = std::min<std::size_t>(device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>(),
                                                 device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>() / 4);
  const std::size_t step = kWorkGroup * kVectorBytes;
  return std::min(kBufferBytes, most) / step * step;
}

cl::Kernel buildCopy(const cl::Context& context, const cl::Device& device) {
  cl::Program program(context, kSource);
  program.build({device}, "-cl-std=CL1.2");
  return cl::Kernel(program, "copy");
}

CopyBandwidth measure(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue) {
  const std::size_t bytes = bufferBytes(device);
  const cl::Buffer from(context, CL_MEM_READ_WRITE, bytes);
  const cl::Buffer to(context, CL_MEM_READ_WRITE, bytes);
  queue.enqueueFillBuffer(from, cl_float(1.0f), 0, bytes);  // so that every page exists
  cl::Kernel kernel = buildCopy(context, device);
  kernel.setArg(0, from);
  kernel.setArg(1, to);
  const std::size_t group = std::min(kWorkGroup, kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device));
  const std::size_t items = bytes / kVectorBytes / group * group;
  const double seconds = medianSeconds(queue, kernel, items, group, {kWarmUps, kRuns});
  const double bytesPerSecond = 2.0 * double(items * kVectorBytes) / seconds;
  return {bytesPerSecond * 1e-9, kCopyBytes / bytesPerSecond * 1e3};
}

}  // namespace

CopyBandwidth measureCopyBandwidth(cl_context context, cl_device_id device, cl_command_queue queue) {
  return withClErrors("copy bandwidth", [&] {
    return measure(cl::Context(context, true), cl::Device(device, true), cl::CommandQueue(queue, true));
  });
}

CopyBandwidth mean(const std::vector<CopyBandwidth>& measurements) {
  CopyBandwidth result;
  for (const CopyBandwidth& one : measurements)
    result.copyMs += one.copyMs / static_cast<double>(measurements.size());
  result.gigabytesPerSecond = kCopyBytes * 1e-6 / result.copyMs;
  return result;
}

}  // namespace quell
