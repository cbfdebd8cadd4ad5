// Checks of what a caller makes a denoiser with, before anything is done with it.
#pragma once

#include <quell/denoiser.hpp>
#include <vector>

#include "host/core/opencl.hpp"

namespace quell {

/// Throws Error(InvalidArgument) for a null handle.
void checkHandles(cl_context context, cl_device_id device, cl_command_queue queue);
/// Throws Error(WrongContext) for a queue of another context or device, Error(InvalidArgument) for timers that it cannot
/// serve. For `function`, which the caller called.
void checkQueue(const char* function, const cl::Context& context, const cl::Device& device,
                const cl::CommandQueue& queue, const Options& options);
/// Throws Error(InvalidArgument).
void checkOptions(const Options& options);
/// The wait list as events. Throws Error(InvalidArgument) for a null event, Error(WrongContext) for one of another
/// context, Error(DeviceError) for one that has failed.
std::vector<cl::Event> checkedEvents(const std::vector<cl_event>& waitList, const cl::Context& context);

}  // namespace quell
