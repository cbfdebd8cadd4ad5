#include "host/core/whole_file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <random>
#include <system_error>

namespace quell {
namespace {

std::string errnoText() { return std::generic_category().message(errno != 0 ? errno : EIO); }

/// Writes and closes; closing is where a full disk may show first.
bool writeParts(const std::string& path, const std::vector<FilePart>& parts) {
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  bool complete = true;
  for (const FilePart& part : parts)
    complete = complete && (part.size == 0 || std::fwrite(part.bytes, 1, part.size, file) == part.size);
  const bool flushed = std::fflush(file) == 0;
  const int failure = errno;
  const bool closed = std::fclose(file) == 0;
  if (!complete || !flushed) errno = failure;
  return complete && flushed && closed;
}

}  // namespace

std::string writeWholeFile(const std::string& path, const std::vector<FilePart>& parts) {
  const std::string temporary = path + "." + std::to_string(std::random_device{}()) + ".tmp";
  std::error_code ignored;
  if (!writeParts(temporary, parts)) {
    const std::string problem = errnoText();
    std::filesystem::remove(temporary, ignored);
    return problem;
  }
  std::error_code failure;
  std::filesystem::rename(temporary, path, failure);
  if (!failure) return "";
  std::filesystem::remove(temporary, ignored);
  return failure.message();
}

}  // namespace quell
