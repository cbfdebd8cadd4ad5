// The one exception type of Quell.
#pragma once

#include <quell/api.h>

#include <stdexcept>
#include <string>

namespace quell {

/// What kind of thing went wrong; stable across releases, so that callers may switch on it.
enum class ErrorCode {
  InvalidArgument,  ///< a value, size, layout or handle was refused before anything was launched
  UnknownSetting,   ///< a method or setting name that does not exist
  OutOfRange,       ///< a setting, or a camera for half positions, outside its documented range
  NotPrepared,      ///< denoise() before prepare(), or with a size or layout that was not prepared
  WrongContext,     ///< a buffer, queue or device that belongs to another OpenCL context
  BuildFailed,      ///< the device's compiler refused a kernel; `got` carries the build log
  DeviceError,      ///< an OpenCL call failed; `got` names the OpenCL error
  OutOfMemory,      ///< host or device memory ran out
  NoDevice,         ///< no OpenCL platform, or no platform with a usable device
  FileError,        ///< a file is missing, unreadable, malformed or could not be written
};

/// The name of a code, for example "InvalidArgument".
QUELL_API const char* toString(ErrorCode code);

/// Where an error happened and how reality differed from what was expected.
struct ErrorDetails {
  std::string stage;     ///< the stage, command or function that refused, for example "accumulate_noisy"
  std::string buffer;    ///< the buffer, setting, argument or file concerned; may be empty
  std::string expected;  ///< what was expected, with unit
  std::string got;       ///< what came instead
};

/// Thrown by every function of Quell that can fail. what() is one sentence made of all the fields.
class QUELL_API Error : public std::runtime_error {
 public:
  Error(ErrorCode code, ErrorDetails details);  ///< makes the sentence of what()

  ErrorCode code() const noexcept { return m_code; }  ///< what kind of thing went wrong
  /// ErrorDetails::stage; all texts live as long as the exception.
  const std::string& stage() const noexcept { return m_details.stage; }
  const std::string& buffer() const noexcept { return m_details.buffer; }      ///< ErrorDetails::buffer
  const std::string& expected() const noexcept { return m_details.expected; }  ///< ErrorDetails::expected
  const std::string& got() const noexcept { return m_details.got; }            ///< ErrorDetails::got

 private:
  ErrorCode m_code;
  ErrorDetails m_details;
};

}  // namespace quell
