// The boundary between the C API and C++: exceptions become a status and the thread's last error; structs of other
// versions of the header are taken and filled.
#pragma once

#include <quell/quell.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <quell/error.hpp>
#include <string>
#include <vector>

namespace quell::c_api {

quell_status toStatus(ErrorCode code);

/// Keeps the exception that is being handled as this thread's last error. Call in a catch block.
quell_status recordCurrentException(const char* function) noexcept;

/// Runs the body of a C function.
template <class Body>
quell_status guarded(const char* function, Body&& body) noexcept {
  try {
    body();
    return QUELL_SUCCESS;
  } catch (...) {
    return recordCurrentException(function);
  }
}

/// Throws Error(InvalidArgument) for a null pointer.
void require(const void* pointer, const char* function, const char* argument);
/// Throws Error(InvalidArgument) unless index < count.
void requireIndex(std::size_t index, std::size_t count, const char* function, const char* argument);

/// A wait list as C++ has it. Throws Error(InvalidArgument) for events without a list.
std::vector<cl_event> toEvents(cl_uint count, const cl_event* waitList, const char* function);

/// Throws Error(InvalidArgument) for an array of the caller's that is too small, or absent in spite of its capacity.
void requireCapacity(const void* array, std::size_t capacity, std::size_t needed, const char* function,
                     const char* argument);

[[noreturn]] void refuseStructSize(const char* function, const char* argument, std::size_t expected,
                                   std::size_t got);

/// Size of a struct in its first release. One that grows later gets a specialisation: offsetof its first new field.
template <class Struct>
constexpr std::size_t kFirstReleaseSize = sizeof(Struct);

template <>
inline constexpr std::size_t kFirstReleaseSize<quell_options> = offsetof(quell_options, keptBuffers);
template <>
inline constexpr std::size_t kFirstReleaseSize<quell_stage_timings> = offsetof(quell_stage_timings, label);

/// A struct of the caller as this version of the header has it: fields beyond the caller's are zero. Throws
/// Error(InvalidArgument) for null, a structSize below the first release's, or bytes beyond what is known here that
/// are not zero.
template <class Struct>
Struct readStruct(const Struct* given, const char* function, const char* argument) {
  require(given, function, argument);
  const std::size_t bytes = given->structSize;
  if (bytes < kFirstReleaseSize<Struct>) refuseStructSize(function, argument, sizeof(Struct), bytes);
  const auto* begin = reinterpret_cast<const unsigned char*>(given);
  if (std::any_of(begin + std::min(bytes, sizeof(Struct)), begin + bytes,
                  [](unsigned char byte) { return byte != 0; }))
    refuseStructSize(function, argument, sizeof(Struct), bytes);
  Struct result{};
  std::memcpy(&result, given, std::min(bytes, sizeof(Struct)));
  return result;
}

/// Fills as much of a result as the caller's version of the struct has. Throws Error(InvalidArgument) for null and a
/// structSize below the first release's.
template <class Struct>
void writeStruct(Struct* target, Struct value, const char* function, const char* argument) {
  require(target, function, argument);
  const std::size_t bytes = target->structSize;
  if (bytes < kFirstReleaseSize<Struct>) refuseStructSize(function, argument, sizeof(Struct), bytes);
  value.structSize = bytes;
  std::memcpy(target, &value, std::min(bytes, sizeof(Struct)));
}

}  // namespace quell::c_api
