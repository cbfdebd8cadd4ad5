// The one place where OpenCL errors become quell::Error.
#pragma once

#include <quell/error.hpp>
#include <string>

#include "host/core/opencl.hpp"

namespace quell {

/// "CL_INVALID_MEM_OBJECT" for -38, "OpenCL error -9999" for unknown codes.
std::string clErrorName(cl_int code);

/// OutOfMemory for the codes that mean it, DeviceError for the rest. `what` names the OpenCL call.
Error translateClError(cl_int code, const std::string& what, const std::string& stage,
                       const std::string& buffer = "");

/// Runs `work`; an OpenCL error or failed host allocation in it becomes a quell::Error of `stage`.
template <class Work>
auto withClErrors(const std::string& stage, Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const cl::Error& error) {
    throw translateClError(error.err(), error.what(), stage);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::OutOfMemory, {stage, "", "enough host memory", "std::bad_alloc"});
  }
}

}  // namespace quell
