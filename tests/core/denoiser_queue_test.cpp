// Queues and events: order of execution, wait lists, completion.
#include <catch2/catch.hpp>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kLastFrame = 3;

}  // namespace

TEST_CASE("in-order and out-of-order queues give bit-identical pictures", "[core]") {
  SmallDenoiser inOrder;
  SmallDenoiser outOfOrder({}, testOptions(), CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
  CHECK(inOrder.run(0, kLastFrame) == outOfOrder.run(0, kLastFrame));
}

TEST_CASE("frames may be in flight together", "[core]") {
  for (const cl_command_queue_properties properties :
       {cl_command_queue_properties{0},
        cl_command_queue_properties{CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE}}) {
    SmallDenoiser oneByOne, together({}, testOptions(), properties);
    for (int i = 0; i < kLastFrame; ++i) oneByOne.enqueue().wait();
    Event last;
    for (int i = 0; i < kLastFrame; ++i) last = together.enqueue();
    last.wait();
    CHECK(oneByOne.buffers.download() == together.buffers.download());
  }
}

TEST_CASE("nothing runs before the wait list has completed and denoise() does not wait for it", "[core]") {
  for (const cl_command_queue_properties properties :
       {cl_command_queue_properties{0},
        cl_command_queue_properties{CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE}}) {
    SmallDenoiser small({}, testOptions(), properties);
    const Picture expected = small.run(0);
    small.denoiser.resetHistory();
    small.buffers.upload(0);
    const Picture untouched = small.buffers.download();
    const cl::CommandQueue reader(small.device.context, small.device.device);

    Gate gate(small.device.context), other(small.device.context);
    const Event done = small.enqueue({gate.event(), other.event()});
    CHECK(statusOf(done) > CL_RUNNING);
    other.open();
    CHECK(statusOf(done) > CL_RUNNING);
    const ImageView& linear = small.buffers.output.linear;
    std::vector<unsigned char> bytes(linear.requiredBytes(small.buffers.frame.size));
    reader.enqueueReadBuffer(cl::Buffer(linear.memory, true), CL_TRUE, 0, bytes.size(), bytes.data());
    CHECK(decodeImage(bytes, linear, small.buffers.frame.size).pixels == untouched.linear.pixels);

    gate.open();
    done.wait();
    CHECK(statusOf(done) == CL_COMPLETE);
    CHECK(small.buffers.download() == expected);
  }
}

}  // namespace quell::tests
