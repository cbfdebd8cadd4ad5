#include "host/measure/timed_run.hpp"

#include <chrono>
#include <utility>
#include <vector>

#include "host/core/frame_timer.hpp"
#include "host/core/median.hpp"

namespace quell {
namespace {

double timedRun(const cl::CommandQueue& queue, const cl::Kernel& kernel, std::size_t items,
                std::size_t group) {
  constexpr double kSecondsPerNanosecond = 1e-9;
  cl::Event event;
  const auto begin = std::chrono::steady_clock::now();
  queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(items), cl::NDRange(group), nullptr, &event);
  event.wait();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  if (!FrameTimer::hasDeviceTimes(event)) return wall.count();
  return double(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                event.getProfilingInfo<CL_PROFILING_COMMAND_START>()) *
         kSecondsPerNanosecond;
}

}  // namespace

double medianSeconds(const cl::CommandQueue& queue, const cl::Kernel& kernel, std::size_t items,
                     std::size_t group, Repetitions repetitions) {
  for (int i = 0; i < repetitions.warmUps; ++i) timedRun(queue, kernel, items, group);
  std::vector<double> seconds;
  for (int i = 0; i < repetitions.runs; ++i) seconds.push_back(timedRun(queue, kernel, items, group));
  return median(std::move(seconds));
}

}  // namespace quell
