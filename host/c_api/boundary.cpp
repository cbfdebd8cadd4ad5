#include "host/c_api/boundary.hpp"

#include <exception>
#include <new>
#include <utility>

namespace quell::c_api {
namespace {

struct LastError {
  quell_status status = QUELL_SUCCESS;
  std::string message, stage, buffer, expected, got;
};
thread_local LastError lastError;

void record(const Error& error) {
  LastError now;
  now.status = toStatus(error.code());
  now.message = error.what();
  now.stage = error.stage();
  now.buffer = error.buffer();
  now.expected = error.expected();
  now.got = error.got();
  lastError = std::move(now);
}

/// Without memory there are no texts, but still a status.
quell_status recordStatusAlone(quell_status status) noexcept {
  lastError = {};
  lastError.status = status;
  return status;
}

quell_status recordDefect(const char* function, const char* what) noexcept {
  try {
    lastError = {QUELL_INTERNAL_ERROR, std::string(function) + ": " + what, function, "", "", what};
    return lastError.status;
  } catch (const std::bad_alloc&) {
    return recordStatusAlone(QUELL_INTERNAL_ERROR);
  }
}

}  // namespace

quell_status toStatus(ErrorCode code) {
  switch (code) {
    case ErrorCode::InvalidArgument:
      return QUELL_INVALID_ARGUMENT;
    case ErrorCode::UnknownSetting:
      return QUELL_UNKNOWN_SETTING;
    case ErrorCode::OutOfRange:
      return QUELL_OUT_OF_RANGE;
    case ErrorCode::NotPrepared:
      return QUELL_NOT_PREPARED;
    case ErrorCode::WrongContext:
      return QUELL_WRONG_CONTEXT;
    case ErrorCode::BuildFailed:
      return QUELL_BUILD_FAILED;
    case ErrorCode::DeviceError:
      return QUELL_DEVICE_ERROR;
    case ErrorCode::OutOfMemory:
      return QUELL_OUT_OF_MEMORY;
    case ErrorCode::NoDevice:
      return QUELL_NO_DEVICE;
    case ErrorCode::FileError:
      return QUELL_FILE_ERROR;
  }
  return QUELL_INTERNAL_ERROR;
}

quell_status recordCurrentException(const char* function) noexcept {
  try {
    try {
      throw;
    } catch (const Error& error) {
      record(error);
    } catch (const std::bad_alloc&) {
      record(Error(ErrorCode::OutOfMemory, {function, "", "enough host memory", "std::bad_alloc"}));
    }
    return lastError.status;
  } catch (const std::bad_alloc&) {
    return recordStatusAlone(QUELL_OUT_OF_MEMORY);
  } catch (const std::exception& exception) {
    return recordDefect(function, exception.what());
  } catch (...) {
    return recordDefect(function, "an exception of an unknown type");
  }
}

void require(const void* pointer, const char* function, const char* argument) {
  if (pointer == nullptr) throw Error(ErrorCode::InvalidArgument, {function, argument, "a pointer", "NULL"});
}

std::vector<cl_event> toEvents(cl_uint count, const cl_event* waitList, const char* function) {
  if (count == 0) return {};
  require(waitList, function, "waitList");
  return {waitList, waitList + count};
}

void requireIndex(std::size_t index, std::size_t count, const char* function, const char* argument) {
  if (index < count) return;
  throw Error(ErrorCode::InvalidArgument,
              {function, argument, "an index below " + std::to_string(count), std::to_string(index)});
}

void requireCapacity(const void* array, std::size_t capacity, std::size_t needed, const char* function,
                     const char* argument) {
  if (capacity > 0) require(array, function, argument);
  if (array != nullptr && capacity < needed)
    throw Error(ErrorCode::InvalidArgument,
                {function, "capacity", std::to_string(needed) + " or more", std::to_string(capacity)});
}

void refuseStructSize(const char* function, const char* argument, std::size_t expected, std::size_t got) {
  throw Error(ErrorCode::InvalidArgument,
              {function, std::string(argument) + ".structSize",
               std::to_string(expected) + " as QUELL_INIT sets it, and zero in fields of newer versions",
               std::to_string(got)});
}

}  // namespace quell::c_api

using namespace quell::c_api;

extern "C" {

const char* quellVersion(void) { return QUELL_VERSION; }

const char* quellStatusName(quell_status status) {
  switch (status) {
    case QUELL_SUCCESS:
      return "Success";
    case QUELL_INVALID_ARGUMENT:
      return "InvalidArgument";
    case QUELL_UNKNOWN_SETTING:
      return "UnknownSetting";
    case QUELL_OUT_OF_RANGE:
      return "OutOfRange";
    case QUELL_NOT_PREPARED:
      return "NotPrepared";
    case QUELL_WRONG_CONTEXT:
      return "WrongContext";
    case QUELL_BUILD_FAILED:
      return "BuildFailed";
    case QUELL_DEVICE_ERROR:
      return "DeviceError";
    case QUELL_OUT_OF_MEMORY:
      return "OutOfMemory";
    case QUELL_NO_DEVICE:
      return "NoDevice";
    case QUELL_FILE_ERROR:
      return "FileError";
    case QUELL_INTERNAL_ERROR:
      return "InternalError";
  }
  return "Unknown";
}

const char* quellErrorMessage(void) { return lastError.message.c_str(); }

quell_status quellGetLastError(quell_error* error) {
  return guarded("quellGetLastError", [&] {
    writeStruct(error,
                {0, lastError.status, lastError.message.c_str(), lastError.stage.c_str(),
                 lastError.buffer.c_str(), lastError.expected.c_str(), lastError.got.c_str()},
                "quellGetLastError", "error");
  });
}

}  // extern "C"
