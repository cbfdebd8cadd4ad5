// Unusable handles and options of the constructor.
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

void construct(cl_context context, cl_device_id device, cl_command_queue queue,
               const Options& options = testOptions()) {
  const Denoiser denoiser(context, device, queue, Settings(), options);
}

}  // namespace

TEST_CASE("null handles are refused", "[errors]") {
  const OpenDevice d;
  const auto refusal = [](const char* name) {
    return Refusal{ErrorCode::InvalidArgument, "Denoiser", name, "OpenCL handle", "null"};
  };
  checkRefused(refusal("context"), [&] { construct(nullptr, d.device(), d.queue()); });
  checkRefused(refusal("device"), [&] { construct(d.context(), nullptr, d.queue()); });
  checkRefused(refusal("queue"), [&] { construct(d.context(), d.device(), nullptr); });
  checkRefused(refusal("queue"), [&] { const Denoiser denoiser(d.context, d.device, cl::CommandQueue()); });
  CHECK_NOTHROW(construct(d.context(), d.device(), d.queue()));
}

TEST_CASE("a queue of another context is refused", "[errors]") {
  const OpenDevice d, other;
  checkRefused({ErrorCode::WrongContext, "Denoiser", "queue", "the given context", "another"},
               [&] { construct(d.context(), d.device(), other.queue()); });
}

TEST_CASE("a device that is not the queue's is refused", "[errors]") {
  const OpenDevice d;
  std::vector<cl::Device> parts;
  const cl_device_partition_property split[] = {CL_DEVICE_PARTITION_EQUALLY, 1, 0};
  try {
    cl::Device whole = d.device;
    whole.createSubDevices(split, &parts);
  } catch (const cl::Error&) {
    WARN("the device cannot be split: nothing to test with");
    return;
  }
  checkRefused({ErrorCode::WrongContext, "Denoiser", "queue", "the given device", "another"},
               [&] { construct(d.context(), parts.front()(), d.queue()); });
}

TEST_CASE("device timers need a queue with profiling", "[errors]") {
  const OpenDevice plain, profiling(CL_QUEUE_PROFILING_ENABLE);
  checkRefused(
      {ErrorCode::InvalidArgument, "Denoiser", "options.timers", "CL_QUEUE_PROFILING_ENABLE", "without"},
      [&] { construct(plain.context(), plain.device(), plain.queue(), testOptions(TimerMode::Device)); });
  CHECK_NOTHROW(construct(plain.context(), plain.device(), plain.queue(), testOptions(TimerMode::Host)));
  CHECK_NOTHROW(
      construct(profiling.context(), profiling.device(), profiling.queue(), testOptions(TimerMode::Device)));
}

TEST_CASE("unusable options are refused", "[errors]") {
  const OpenDevice d;
  for (const std::size_t axis : {0, 1}) {
    Options options = testOptions();
    options.workGroup[axis] = -3;
    checkRefused({ErrorCode::InvalidArgument, "Denoiser", "options.workGroup", "positive", "-3"},
                 [&] { construct(d.context(), d.device(), d.queue(), options); });
  }
  for (const int group : {3, -1, 512, 255}) {
    Options options = testOptions();
    options.fitGroup = group;
    checkRefused({ErrorCode::InvalidArgument, "Denoiser", "options.fitGroup", "power of two up to 256",
                  std::to_string(group)},
                 [&] { construct(d.context(), d.device(), d.queue(), options); });
  }
}

}  // namespace quell::tests
