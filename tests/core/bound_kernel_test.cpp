// What a kernel was bound to before must not show.
#include "host/core/bound_kernel.hpp"

#include <catch2/catch.hpp>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr char kSource[] =
    "__kernel void add(__global const int* a, __global const int* b, __global int* sum, int scale) {"
    "  sum[0] = scale * ((a ? a[0] : 0) + b[0]);"
    "}";

class Adder {
 public:
  explicit Adder(const OpenDevice& device)
      : m_queue(device.queue),
        m_kernel(cl::Kernel(build(device.context), "add")),
        m_sum(device.context, CL_MEM_READ_WRITE, sizeof(cl_int)) {}

  cl_int operator()(Argument a, Argument b, cl_int scale) {
    m_kernel.bind({a, b, {m_sum(), true}}, &scale, sizeof(scale));
    m_queue.enqueueNDRangeKernel(m_kernel, cl::NullRange, cl::NDRange(1), cl::NDRange(1));
    cl_int sum = 0;
    m_queue.enqueueReadBuffer(m_sum, CL_TRUE, 0, sizeof(sum), &sum);
    return sum;
  }

 private:
  static cl::Program build(const cl::Context& context) {
    cl::Program program(context, kSource);
    program.build("-cl-std=CL1.2");
    return program;
  }

  cl::CommandQueue m_queue;
  BoundKernel m_kernel;
  cl::Buffer m_sum;
};

cl::Buffer bufferOf(const OpenDevice& device, cl_int value) {
  return cl::Buffer(device.context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, sizeof(value), &value);
}

}  // namespace

TEST_CASE("a kernel runs with the arguments of the latest launch", "[core]") {
  const OpenDevice device;
  Adder add(device);
  const cl::Buffer one = bufferOf(device, 1), two = bufferOf(device, 2), ten = bufferOf(device, 10);
  for (const bool own : {true, false}) {
    INFO("own memory: " << own);
    CHECK(add({one(), own}, {ten(), own}, 1) == 11);
    CHECK(add({one(), own}, {ten(), own}, 1) == 11);
    CHECK(add({two(), own}, {ten(), own}, 1) == 12);
    CHECK(add({two(), own}, {ten(), own}, -1) == -12);
    CHECK(add({ten(), own}, {two(), own}, -1) == -12);
    CHECK(add({nullptr, own}, {two(), own}, 3) == 6);
    CHECK(add({one(), own}, {one(), own}, 3) == 6);
  }
}

TEST_CASE("memory of the caller is bound anew where other memory has come to its address", "[core]") {
  const OpenDevice device;
  Adder add(device);
  const cl::Buffer one = bufferOf(device, 1);
  for (cl_int value = 0; value < 20; ++value) {
    const cl::Buffer shortLived = bufferOf(device, value);
    CHECK(add({shortLived(), false}, {one(), true}, 1) == value + 1);
  }
}

}  // namespace quell::tests
