#include "host/core/handle_checks.hpp"

#include <quell/error.hpp>
#include <string>

#include "host/core/cl_error.hpp"

namespace quell {

void checkHandles(cl_context context, cl_device_id device, cl_command_queue queue) {
  const auto require = [](bool present, const char* name) {
    if (!present) throw Error(ErrorCode::InvalidArgument, {"Denoiser", name, "an OpenCL handle", "null"});
  };
  require(context != nullptr, "context");
  require(device != nullptr, "device");
  require(queue != nullptr, "queue");
}

void checkQueue(const char* function, const cl::Context& context, const cl::Device& device,
                const cl::CommandQueue& queue, const Options& options) {
  if (queue.getInfo<CL_QUEUE_CONTEXT>()() != context())
    throw Error(ErrorCode::WrongContext,
                {function, "queue", "a queue of the given context", "another context's"});
  if (queue.getInfo<CL_QUEUE_DEVICE>()() != device())
    throw Error(ErrorCode::WrongContext,
                {function, "queue", "a queue of the given device", "another device's"});
  const bool profiling = (queue.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_PROFILING_ENABLE) != 0;
  if (options.timers == TimerMode::Device && !profiling) {
    throw Error(ErrorCode::InvalidArgument,
                {function, "options.timers", "a queue with CL_QUEUE_PROFILING_ENABLE for device timers",
                 "a queue without it"});
  }
}

void checkOptions(const Options& options) {
  const auto refuse = [](const char* name, const char* expected, int got) {
    throw Error(ErrorCode::InvalidArgument, {"Denoiser", name, expected, std::to_string(got)});
  };
  for (const int extent : options.workGroup)
    if (extent < 0) refuse("options.workGroup", "0 or a positive number of work-items", extent);
  const int group = options.fitGroup;
  if (group < 0 || group > 256 || (group & (group - 1)) != 0)
    refuse("options.fitGroup", "0 or a power of two up to 256", group);
  if (options.captureFrames < 1) refuse("options.captureFrames", "1 or more frames", options.captureFrames);
  if (options.captureSkip < 0) refuse("options.captureSkip", "0 or more frames", options.captureSkip);
}

std::vector<cl::Event> checkedEvents(const std::vector<cl_event>& waitList, const cl::Context& context) {
  const auto refuse = [](ErrorCode code, const char* expected, const std::string& got) {
    throw Error(code, {"denoise", "waitList", expected, got});
  };
  std::vector<cl::Event> events;
  for (cl_event event : waitList) {
    if (event == nullptr) refuse(ErrorCode::InvalidArgument, "events", "a null event");
    events.emplace_back(event, true);
    if (events.back().getInfo<CL_EVENT_CONTEXT>()() != context())
      refuse(ErrorCode::WrongContext, "events of the denoiser's context", "one of another context");
    // Commands that wait for an event that has failed already never end on some runtimes (PoCL 3.1).
    const cl_int status = events.back().getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>();
    if (status < 0)
      refuse(ErrorCode::DeviceError, "events that have not failed", "one with status " + clErrorName(status));
  }
  return events;
}

}  // namespace quell
