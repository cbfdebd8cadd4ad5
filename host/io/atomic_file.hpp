// Writing files so that a reader never sees half of one.
#pragma once

#include <cstddef>
#include <string>

namespace quell::io {

/// Writes `size` bytes to `path`: first to a temporary name in the same directory, renamed when everything
/// has reached the file system. On failure (missing or unwritable directory, disk full) the temporary is
/// removed, a file that was there before stays as it was, and Error(FileError) says what went wrong.
///
/// A symbolic link is followed; a device or pipe (/dev/stdout) cannot be replaced and is written directly.
/// This guards against failing writes and concurrent readers, not against loss of power: nothing is synced to
/// disk.
void writeBinaryFile(const std::string& path, const void* bytes, std::size_t size);

/// As writeBinaryFile(); the text is written as it is, without a line end of its own.
void writeTextFile(const std::string& path, const std::string& text);

/// The whole of a file. Throws Error(FileError) if it is missing or cannot be read.
std::string readFile(const std::string& path);

}  // namespace quell::io
