#include "host/io/atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <system_error>
#include <utility>

#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

namespace fs = std::filesystem;

constexpr char kStage[] = "write file";
/// How many random temporary names are tried before giving up; a second clash is already next to impossible.
constexpr int kMaxNameAttempts = 8;

std::string errnoText() { return errno != 0 ? std::strerror(errno) : "an unknown error"; }

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FilePtr = std::unique_ptr<std::FILE, CloseFile>;

/// Removes a file at the end of the scope unless release() was called.
class RemoveOnFailure {
 public:
  explicit RemoveOnFailure(fs::path path) : m_path(std::move(path)) {}
  RemoveOnFailure(const RemoveOnFailure&) = delete;
  RemoveOnFailure& operator=(const RemoveOnFailure&) = delete;
  ~RemoveOnFailure() {
    std::error_code ignored;
    if (!m_path.empty()) fs::remove(m_path, ignored);
  }
  void release() { m_path.clear(); }

 private:
  fs::path m_path;
};

/// Creates a new file beside `path`; `temporary` receives its name.
FilePtr createTemporary(const fs::path& path, fs::path& temporary) {
  std::random_device random;
  for (int attempt = 0; attempt < kMaxNameAttempts; ++attempt) {
    temporary = path;
    temporary += ".tmp-" + std::to_string(random());
    errno = 0;
    FilePtr file(std::fopen(temporary.c_str(), "wbx"));
    if (file) return file;
    if (errno != EEXIST) break;
  }
  throwFileError(kStage, path.string(), "a directory in which a file can be created", errnoText());
}

/// Writes and closes. Closing is checked too: that is where a full disk shows with buffered writes.
void writeAndClose(FilePtr file, const std::string& path, const void* bytes, std::size_t size) {
  errno = 0;
  bool complete = std::fwrite(bytes, 1, size, file.get()) == size;
  complete = complete && std::fflush(file.get()) == 0;
  complete = std::fclose(file.release()) == 0 && complete;
  if (!complete) throwFileError(kStage, path, "to write " + std::to_string(size) + " bytes", errnoText());
}

/// Whether the file cannot be replaced by another: a device, a pipe, or a name such as /dev/stdout, which may
/// lead to a regular file that others hold open.
bool mustStayInPlace(const std::string& path) {
  constexpr char kDeviceDirectory[] = "/dev/";
  std::error_code failure;
  const fs::file_status target = fs::status(path, failure);
  return fs::exists(target) && (!fs::is_regular_file(target) || path.rfind(kDeviceDirectory, 0) == 0);
}

/// Appends, which devices do not tell from writing, so that a redirected output keeps what it has.
void writeInPlace(const std::string& path, const void* bytes, std::size_t size) {
  errno = 0;
  FilePtr file(std::fopen(path.c_str(), "ab"));
  if (!file) throwFileError(kStage, path, "a writable device or pipe", errnoText());
  writeAndClose(std::move(file), path, bytes, size);
}

void writeAndRename(const fs::path& path, const void* bytes, std::size_t size) {
  fs::path temporary;
  FilePtr file = createTemporary(path, temporary);
  RemoveOnFailure guard(temporary);
  writeAndClose(std::move(file), path.string(), bytes, size);
  std::error_code failure;
  fs::rename(temporary, path, failure);
  if (failure) throwFileError(kStage, path.string(), "to rename the finished file", failure.message());
  guard.release();
}

}  // namespace

void writeBinaryFile(const std::string& path, const void* bytes, std::size_t size) {
  std::error_code failure;
  if (fs::is_directory(path, failure)) throwFileError(kStage, path, "a file name", "a directory");
  if (mustStayInPlace(path)) return writeInPlace(path, bytes, size);
  fs::path resolved = fs::canonical(path, failure);  // replaces what a link leads to, not the link
  if (failure) resolved = path;                      // the usual case: there is no such file yet
  writeAndRename(resolved, bytes, size);
}

void writeTextFile(const std::string& path, const std::string& text) {
  writeBinaryFile(path, text.data(), text.size());
}

std::string readFile(const std::string& path) {
  std::error_code failure;
  if (!fs::exists(path, failure)) throwFileError("read file", path, "a readable file", "no such file");
  if (fs::is_directory(path, failure)) throwFileError("read file", path, "a readable file", "a directory");
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream.is_open() || stream.bad()) throwFileError("read file", path, "a readable file", "a read error");
  return text;
}

}  // namespace quell::io
