// Files that appear whole or not at all.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace quell {

struct FilePart {
  const void* bytes = nullptr;
  std::size_t size = 0;
};

/// Writes the parts one after the other into a temporary file beside `path` and renames that. Returns what the system says
/// against it, else an empty text. Throws nothing but failed allocations.
std::string writeWholeFile(const std::string& path, const std::vector<FilePart>& parts);

}  // namespace quell
