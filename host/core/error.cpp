#include <quell/error.hpp>
#include <utility>

namespace quell {
namespace {

std::string describe(ErrorCode code, const ErrorDetails& details) {
  std::string text = toString(code);
  if (!details.stage.empty()) text += " in " + details.stage;
  if (!details.buffer.empty()) text += ", " + details.buffer;
  text += ": expected " + details.expected + ", got " + details.got;
  return text;
}

}  // namespace

const char* toString(ErrorCode code) {
  switch (code) {
    case ErrorCode::InvalidArgument:
      return "InvalidArgument";
    case ErrorCode::UnknownSetting:
      return "UnknownSetting";
    case ErrorCode::OutOfRange:
      return "OutOfRange";
    case ErrorCode::NotPrepared:
      return "NotPrepared";
    case ErrorCode::WrongContext:
      return "WrongContext";
    case ErrorCode::BuildFailed:
      return "BuildFailed";
    case ErrorCode::DeviceError:
      return "DeviceError";
    case ErrorCode::OutOfMemory:
      return "OutOfMemory";
    case ErrorCode::NoDevice:
      return "NoDevice";
    case ErrorCode::FileError:
      return "FileError";
  }
  return "Unknown";
}

Error::Error(ErrorCode code, ErrorDetails details)
    : std::runtime_error(describe(code, details)), m_code(code), m_details(std::move(details)) {}

}  // namespace quell
