// Rendered sequences beyond data/, for tests that need more of them. Such tests have the tag [.sequences] and run as
// tests of their own, which ctest reports as skipped where there are none.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace quell::tests {

/// Sorted directories that hold this file, in the directory that the environment variable QUELL_SEQUENCES names, else in
/// the one that the build was told. Where there are none, says so with the word that ctest looks for.
inline std::vector<std::string> furtherSequences(const std::string& file) {
  const char* chosen = std::getenv("QUELL_SEQUENCES");
  const std::filesystem::path directory = chosen != nullptr ? chosen : QUELL_SEQUENCES_DIR;
  std::vector<std::string> found;
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(directory, failure))
    if (std::filesystem::exists(entry.path() / file)) found.push_back(entry.path().string());
  std::sort(found.begin(), found.end());
  if (found.empty())
    WARN("SKIPPED: no directory of further sequences with " << file << " (set QUELL_SEQUENCES)");
  return found;
}

}  // namespace quell::tests
