#include "host/measure/fma_rate.hpp"

#include <algorithm>
#include <string>

#include "host/core/cl_error.hpp"
#include "host/measure/timed_run.hpp"

namespace quell {
namespace {

// Eight chains hide the latency of a multiply-add (4 to 6 cycles, up to two a cycle).
constexpr int kChains = 8;
constexpr int kRounds = 512;
constexpr int kWarmUps = 1;
constexpr int kRuns = 7;
constexpr std::size_t kWorkGroup = 64;
constexpr int kWideLanes = 16;
// Work-items per compute unit: enough for every GPU to be full.
constexpr std::size_t kItemsPerUnit = 4096;

// VALUE is float or float16. The multiplier stays below 1, so that no chain overflows.
constexpr char kSource[] = R"kernel(
#pragma OPENCL FP_CONTRACT ON
__kernel void chains(__global VALUE* out, float multiplier) {
  const VALUE m = (VALUE)(multiplier);
  VALUE a = (VALUE)((float)get_global_id(0)), b = a + 1.0f, c = a + 2.0f, d = a + 3.0f;
  VALUE e = a + 4.0f, f = a + 5.0f, g = a + 6.0f, h = a + 7.0f;
  for (int round = 0; round < ROUNDS; ++round) {
    a = a * m + 1.0f; b = b * m + 1.0f; c = c * m + 1.0f; d = d * m + 1.0f;
    e = e * m + 1.0f; f = f * m + 1.0f; g = g * m + 1.0f; h = h * m + 1.0f;
  }
  out[get_global_id(0)] = ((a + b) + (c + d)) + ((e + f) + (g + h));
}
)kernel";

// GFLOP/s with `lanes` values per work-item.
double measureLanes(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue,
                    int lanes) {
  cl::Program program(context, kSource);
  const std::string type = lanes == 1 ? "float" : "float" + std::to_string(lanes);
  program.build(
      {device},
      ("-cl-std=CL1.2 -cl-mad-enable -D VALUE=" + type + " -D ROUNDS=" + std::to_string(kRounds)).c_str());
  cl::Kernel kernel(program, "chains");
  const std::size_t group = std::min(kWorkGroup, kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device));
  const std::size_t units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
  const std::size_t items = units * kItemsPerUnit / group * group;
  const cl::Buffer out(context, CL_MEM_WRITE_ONLY,
                       items * static_cast<std::size_t>(lanes) * sizeof(cl_float));
  kernel.setArg(0, out);
  kernel.setArg(1, 0.999f);
  const double seconds = medianSeconds(queue, kernel, items, group, {kWarmUps, kRuns});
  const double operations = 2.0 * kChains * kRounds * lanes * double(items);
  return operations / seconds * 1e-9;
}

}  // namespace

double measureFmaRate(cl_context context, cl_device_id device, cl_command_queue queue) {
  return withClErrors("fma rate", [&] {
    const cl::Context sharedContext(context, true);
    const cl::Device sharedDevice(device, true);
    const cl::CommandQueue sharedQueue(queue, true);
    return std::max(measureLanes(sharedContext, sharedDevice, sharedQueue, 1),
                    measureLanes(sharedContext, sharedDevice, sharedQueue, kWideLanes));
  });
}

}  // namespace quell
