#include "host/core/cl_error.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace quell {
namespace {

struct NamedCode {
  cl_int code;
  const char* name;
};

#define QUELL_NAMED(code) \
  { code, #code }
constexpr NamedCode kNames[] = {
    QUELL_NAMED(CL_DEVICE_NOT_FOUND),
    QUELL_NAMED(CL_DEVICE_NOT_AVAILABLE),
    QUELL_NAMED(CL_COMPILER_NOT_AVAILABLE),
    QUELL_NAMED(CL_MEM_OBJECT_ALLOCATION_FAILURE),
    QUELL_NAMED(CL_OUT_OF_RESOURCES),
    QUELL_NAMED(CL_OUT_OF_HOST_MEMORY),
    QUELL_NAMED(CL_PROFILING_INFO_NOT_AVAILABLE),
    QUELL_NAMED(CL_MEM_COPY_OVERLAP),
    QUELL_NAMED(CL_BUILD_PROGRAM_FAILURE),
    QUELL_NAMED(CL_MAP_FAILURE),
    QUELL_NAMED(CL_MISALIGNED_SUB_BUFFER_OFFSET),
    QUELL_NAMED(CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST),
    QUELL_NAMED(CL_INVALID_VALUE),
    QUELL_NAMED(CL_INVALID_DEVICE_TYPE),
    QUELL_NAMED(CL_INVALID_PLATFORM),
    QUELL_NAMED(CL_INVALID_DEVICE),
    QUELL_NAMED(CL_INVALID_CONTEXT),
    QUELL_NAMED(CL_INVALID_QUEUE_PROPERTIES),
    QUELL_NAMED(CL_INVALID_COMMAND_QUEUE),
    QUELL_NAMED(CL_INVALID_HOST_PTR),
    QUELL_NAMED(CL_INVALID_MEM_OBJECT),
    QUELL_NAMED(CL_INVALID_BINARY),
    QUELL_NAMED(CL_INVALID_BUILD_OPTIONS),
    QUELL_NAMED(CL_INVALID_PROGRAM),
    QUELL_NAMED(CL_INVALID_PROGRAM_EXECUTABLE),
    QUELL_NAMED(CL_INVALID_KERNEL_NAME),
    QUELL_NAMED(CL_INVALID_KERNEL_DEFINITION),
    QUELL_NAMED(CL_INVALID_KERNEL),
    QUELL_NAMED(CL_INVALID_ARG_INDEX),
    QUELL_NAMED(CL_INVALID_ARG_VALUE),
    QUELL_NAMED(CL_INVALID_ARG_SIZE),
    QUELL_NAMED(CL_INVALID_KERNEL_ARGS),
    QUELL_NAMED(CL_INVALID_WORK_DIMENSION),
    QUELL_NAMED(CL_INVALID_WORK_GROUP_SIZE),
    QUELL_NAMED(CL_INVALID_WORK_ITEM_SIZE),
    QUELL_NAMED(CL_INVALID_GLOBAL_OFFSET),
    QUELL_NAMED(CL_INVALID_EVENT_WAIT_LIST),
    QUELL_NAMED(CL_INVALID_EVENT),
    QUELL_NAMED(CL_INVALID_OPERATION),
    QUELL_NAMED(CL_INVALID_BUFFER_SIZE),
    QUELL_NAMED(CL_INVALID_GLOBAL_WORK_SIZE),
    QUELL_NAMED(CL_INVALID_PROPERTY),
};
#undef QUELL_NAMED

bool meansOutOfMemory(cl_int code) {
  return code == CL_MEM_OBJECT_ALLOCATION_FAILURE || code == CL_OUT_OF_RESOURCES ||
         code == CL_OUT_OF_HOST_MEMORY || code == CL_INVALID_BUFFER_SIZE;
}

}  // namespace

std::string clErrorName(cl_int code) {
  const auto* found = std::find_if(std::begin(kNames), std::end(kNames),
                                   [code](const NamedCode& named) { return named.code == code; });
  return found != std::end(kNames) ? found->name : "OpenCL error " + std::to_string(code);
}

Error translateClError(cl_int code, const std::string& what, const std::string& stage,
                       const std::string& buffer) {
  const ErrorCode kind = meansOutOfMemory(code) ? ErrorCode::OutOfMemory : ErrorCode::DeviceError;
  return Error(kind, {stage, buffer, what + " to succeed", clErrorName(code)});
}

}  // namespace quell
