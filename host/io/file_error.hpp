// The one way files are refused: Error(FileError) with the file, what was expected and what came instead.
#pragma once

#include <quell/error.hpp>
#include <string>

namespace quell::io {

/// Throws Error(FileError). `stage` is the refusing function, `path` the file or directory concerned.
[[noreturn]] inline void throwFileError(const std::string& stage, const std::string& path,
                                        const std::string& expected, const std::string& got) {
  throw Error(ErrorCode::FileError, {stage, path, expected, got});
}

}  // namespace quell::io
