// The library never prints, nor do the compilers that it calls.
#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>

#include "host/core/program_cache.hpp"
#include "host/io/atomic_file.hpp"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {

TEST_CASE("no compiler's warnings reach the terminal of the host", "[core]") {
  const OpenDevice device;
  const TemporaryDirectory directory;
  // A text that no runtime's cache knows, and that every compiler warns of.
  const std::string source =
      "#warning " + directory.path() + "\n__kernel void warned(__global int* out) { out[0] = 1; }\n";
  std::fflush(stderr);
  const int before = dup(STDERR_FILENO);
  const int text = open(directory.file("stderr").c_str(), O_CREAT | O_WRONLY, 0600);
  dup2(text, STDERR_FILENO);
  cl::Kernel kernel(
      ProgramCache("").build(device.context, device.device,
                             queryDeviceTraits(device.device, Mapping::Automatic), "warned", source, ""),
      "warned");
  const cl::Buffer buffer(device.context, CL_MEM_READ_WRITE, sizeof(cl_int));
  kernel.setArg(0, buffer);
  device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(1), cl::NDRange(1));
  device.queue.finish();
  std::fflush(stderr);
  dup2(before, STDERR_FILENO);
  close(text);
  close(before);
  CHECK(io::readFile(directory.file("stderr")).empty());
}

}  // namespace quell::tests
