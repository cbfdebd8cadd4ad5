// A directory for one test, gone afterwards.
#pragma once

#include <filesystem>
#include <random>
#include <string>

namespace quell::tests {

/// Creates an empty directory under the system's temporary directory and removes it with all it holds.
class TemporaryDirectory {
 public:
  TemporaryDirectory()
      : m_path(std::filesystem::temp_directory_path() /
               ("quell-test-" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directories(m_path);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }

  std::string path() const { return m_path.string(); }
  std::string file(const std::string& name) const { return (m_path / name).string(); }

  /// How many files, directories and links it holds.
  int entryCount() const {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(m_path)) ++count;
    return count;
  }

 private:
  std::filesystem::path m_path;
};

}  // namespace quell::tests
