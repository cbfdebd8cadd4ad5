// Translation of OpenCL errors.
#include "host/core/cl_error.hpp"

#include <catch2/catch.hpp>
#include <new>

namespace quell::tests {

TEST_CASE("OpenCL errors are named", "[core]") {
  CHECK(clErrorName(CL_INVALID_MEM_OBJECT) == "CL_INVALID_MEM_OBJECT");
  CHECK(clErrorName(CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST) ==
        "CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST");
  CHECK(clErrorName(-9999) == "OpenCL error -9999");
}

TEST_CASE("codes that mean lack of memory become OutOfMemory, others DeviceError", "[core]") {
  for (const cl_int code :
       {CL_MEM_OBJECT_ALLOCATION_FAILURE, CL_OUT_OF_RESOURCES, CL_OUT_OF_HOST_MEMORY, CL_INVALID_BUFFER_SIZE})
    CHECK(translateClError(code, "clCall", "fit").code() == ErrorCode::OutOfMemory);
  const Error error = translateClError(CL_INVALID_KERNEL_ARGS, "clCall", "fit", "guides");
  CHECK(error.code() == ErrorCode::DeviceError);
  CHECK(error.stage() == "fit");
  CHECK(error.buffer() == "guides");
  CHECK(error.expected() == "clCall to succeed");
  CHECK(error.got() == "CL_INVALID_KERNEL_ARGS");
  CHECK(error.what() ==
        std::string("DeviceError in fit, guides: expected clCall to succeed, got CL_INVALID_KERNEL_ARGS"));
}

TEST_CASE("withClErrors turns exceptions of clhpp and of the allocator into Errors", "[core]") {
  CHECK(withClErrors("stage", [] { return 7; }) == 7);
  try {
    withClErrors("stage", [] { throw cl::Error(CL_INVALID_VALUE, "clCall"); });
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::DeviceError);
    CHECK(error.stage() == "stage");
    CHECK(error.got() == "CL_INVALID_VALUE");
  }
  try {
    withClErrors("stage", [] { throw std::bad_alloc(); });
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::OutOfMemory);
  }
}

TEST_CASE("every error code has a name of its own", "[core]") {
  std::vector<std::string> names;
  for (int code = 0; code <= static_cast<int>(ErrorCode::FileError); ++code) {
    names.emplace_back(toString(static_cast<ErrorCode>(code)));
    CHECK(names.back() != "Unknown");
    CHECK(std::count(names.begin(), names.end(), names.back()) == 1);
  }
}

}  // namespace quell::tests
