// Two processes that start together share a cold cache directory.
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>

#include "host/core/program_cache.hpp"
#include "tests/support/small_denoiser.hpp"
#include "tests/support/temporary_directory.hpp"

namespace quell::tests {
namespace {

constexpr char kDirectoryVariable[] = "QUELL_TEST_SHARED_CACHE";
constexpr char kChildTag[] = "[child]";
constexpr int kPrograms = 4;

// Builds and runs the programs; true if all of them did what they should.
bool runPrograms(const std::string& directory) {
  const OpenDevice device;
  const DeviceTraits traits = queryDeviceTraits(device.device, Mapping::Automatic);
  const ProgramCache cache(directory);
  bool right = true;
  for (int i = 0; i < kPrograms; ++i) {
    const std::string source =
        "__kernel void number(__global int* out) { out[0] = " + std::to_string(1000 + i) + "; }\n";
    cl::Kernel kernel(cache.build(device.context, device.device, traits, "number", source, ""), "number");
    const cl::Buffer buffer(device.context, CL_MEM_READ_WRITE, sizeof(cl_int));
    kernel.setArg(0, buffer);
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(1), cl::NDRange(1));
    cl_int value = 0;
    device.queue.enqueueReadBuffer(buffer, CL_TRUE, 0, sizeof(value), &value);
    right = right && value == 1000 + i;
  }
  return right;
}

}  // namespace

// Hidden: run by the test below in processes of its own.
TEST_CASE("child: build programs in a shared cache directory", "[.][child]") {
  const char* directory = std::getenv(kDirectoryVariable);
  REQUIRE(directory != nullptr);
  CHECK(runPrograms(directory));
}

TEST_CASE("two processes may start together on one cold cache directory", "[core]") {
  const TemporaryDirectory directory;
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = std::string(kDirectoryVariable) + "='" + directory.path() + "' '" + self +
                              "' '" + kChildTag + "' >/dev/null";
  std::array<std::FILE*, 2> children{};
  for (std::FILE*& child : children) REQUIRE((child = popen(command.c_str(), "r")) != nullptr);
  for (std::FILE* child : children) CHECK(pclose(child) == 0);
  CHECK(directory.entryCount() == kPrograms);  // and no temporary file

  ProgramCache::clearMemory();
  const ProgramCacheCounters before = ProgramCache::counters();
  CHECK(runPrograms(directory.path()));
  CHECK(ProgramCache::counters().fromDisk == before.fromDisk + kPrograms);
  CHECK(ProgramCache::counters().built == before.built);
}

}  // namespace quell::tests
