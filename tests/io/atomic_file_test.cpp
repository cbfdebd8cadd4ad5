#include "host/io/atomic_file.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>

#include "tests/support/error_matcher.hpp"
#include "tests/support/temporary_directory.hpp"

using quell::Error;
using quell::ErrorCode;
using quell::io::readFile;
using quell::io::writeTextFile;
using quell::tests::failsWith;
using quell::tests::TemporaryDirectory;

namespace {

/// Makes this process's writes fail beyond `bytes` per file, as they do on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &m_before);
    rlimit limit = m_before;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &m_before);
    std::signal(SIGXFSZ, m_handler);
  }

 private:
  rlimit m_before{};
  void (*m_handler)(int);
};

}  // namespace

TEST_CASE("a written file holds the text and leaves nothing beside it") {
  const TemporaryDirectory directory;
  writeTextFile(directory.file("a.txt"), "first");
  writeTextFile(directory.file("a.txt"), std::string("sec\0nd", 6));
  REQUIRE(readFile(directory.file("a.txt")) == std::string("sec\0nd", 6));
  REQUIRE(directory.entryCount() == 1);
}

TEST_CASE("a write that fails half-way keeps the old file and removes the temporary") {
  const TemporaryDirectory directory;
  writeTextFile(directory.file("a.txt"), "old");
  {
    const FileSizeLimit limit(1024);
    REQUIRE_THROWS_MATCHES(writeTextFile(directory.file("a.txt"), std::string(100000, 'x')), Error,
                           failsWith(ErrorCode::FileError, {"a.txt", "100000 bytes"}));
  }
  REQUIRE(readFile(directory.file("a.txt")) == "old");
  REQUIRE(directory.entryCount() == 1);
}

TEST_CASE("a full device is noticed even when the text fits the write buffer") {
  if (!std::filesystem::exists("/dev/full")) return;
  REQUIRE_THROWS_MATCHES(writeTextFile("/dev/full", "x"), Error,
                         failsWith(ErrorCode::FileError, {"/dev/full", "No space left"}));
  REQUIRE(std::filesystem::is_character_file("/dev/full"));
}

TEST_CASE("a missing, unwritable or impossible directory is an error") {
  const TemporaryDirectory directory;
  const auto fileError = failsWith(ErrorCode::FileError, {"a.txt"});
  REQUIRE_THROWS_MATCHES(writeTextFile(directory.file("missing/a.txt"), "x"), Error, fileError);
  writeTextFile(directory.file("file"), "x");
  REQUIRE_THROWS_MATCHES(writeTextFile(directory.file("file/a.txt"), "x"), Error, fileError);
  REQUIRE_THROWS_MATCHES(writeTextFile(directory.path(), "x"), Error,
                         failsWith(ErrorCode::FileError, {"a directory"}));
  std::filesystem::create_directory(directory.file("locked"));
  std::filesystem::permissions(directory.file("locked"), std::filesystem::perms::owner_read);
  if (geteuid() != 0)  // the superuser may write anywhere
    REQUIRE_THROWS_MATCHES(writeTextFile(directory.file("locked/a.txt"), "x"), Error, fileError);
  std::filesystem::permissions(directory.file("locked"), std::filesystem::perms::owner_all);
}

TEST_CASE("a symbolic link stays a link") {
  const TemporaryDirectory directory;
  writeTextFile(directory.file("target.txt"), "old");
  std::filesystem::create_symlink("target.txt", directory.file("link.txt"));
  writeTextFile(directory.file("link.txt"), "new");
  REQUIRE(std::filesystem::is_symlink(directory.file("link.txt")));
  REQUIRE(readFile(directory.file("target.txt")) == "new");
}

TEST_CASE("reading says what is wrong with a file") {
  const TemporaryDirectory directory;
  REQUIRE_THROWS_MATCHES(readFile(directory.file("none")), Error,
                         failsWith(ErrorCode::FileError, {"no such file"}));
  REQUIRE_THROWS_MATCHES(readFile(directory.path()), Error, failsWith(ErrorCode::FileError, {"a directory"}));
}
