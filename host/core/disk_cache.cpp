#include "host/core/disk_cache.hpp"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/core/fnv1a.hpp"
#include "host/core/whole_file.hpp"

namespace quell {
namespace {

using Bytes = DiskCache::Bytes;

// First bytes of an entry; the number changes with the layout.
constexpr char kMagic[] = "quell cached result 2\n";

template <class Number>
void append(Bytes& bytes, Number value) {
  const auto* raw = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), raw, raw + sizeof(value));
}

Bytes makeEntry(const std::string& key, const Bytes& bytes) {
  Bytes entry(kMagic, kMagic + sizeof(kMagic) - 1);
  append(entry, static_cast<std::uint64_t>(key.size()));
  append(entry, static_cast<std::uint64_t>(bytes.size()));
  append(entry, fnv1a(bytes.data(), bytes.size()));
  entry.insert(entry.end(), key.begin(), key.end());
  entry.insert(entry.end(), bytes.begin(), bytes.end());
  return entry;
}

Bytes readFile(const std::string& path) {
  try {
    std::ifstream file(path, std::ios::binary);
    return Bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  } catch (const std::ios_base::failure&) {
    return {};  // a directory, a broken disk
  }
}

}  // namespace

std::string DiskCache::pathOf(const std::string& key) const {
  char name[32];
  std::snprintf(name, sizeof(name), "%016llx.bin",
                static_cast<unsigned long long>(fnv1a(key.data(), key.size())));
  return (std::filesystem::path(m_directory) / name).string();
}

// An entry is trusted only if rebuilding it from its own parts gives the same bytes and the key is ours.
std::optional<Bytes> DiskCache::read(const std::string& key) const {
  if (m_directory.empty()) return std::nullopt;
  const Bytes entry = readFile(pathOf(key));
  const std::size_t header = sizeof(kMagic) - 1 + 3 * sizeof(std::uint64_t);
  if (entry.size() < header + key.size()) return std::nullopt;
  const Bytes bytes(entry.begin() + static_cast<std::ptrdiff_t>(header + key.size()), entry.end());
  if (bytes.empty() || makeEntry(key, bytes) != entry) return std::nullopt;
  return bytes;
}

void DiskCache::write(const std::string& key, const Bytes& bytes) const {
  if (m_directory.empty() || bytes.empty()) return;
  std::error_code ignored;
  std::filesystem::create_directories(m_directory, ignored);
  const Bytes entry = makeEntry(key, bytes);
  writeWholeFile(pathOf(key), {{entry.data(), entry.size()}});
}

}  // namespace quell
