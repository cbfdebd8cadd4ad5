// Results that are costly to compute, kept in files from one process to the next.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quell {

/// A directory of entries, each a key and its bytes. Thread-safe. An entry carries its whole key and a
/// checksum; one that does not match to the last byte counts as absent and is replaced by the next write().
/// Entries are written to a temporary name and renamed, so two processes may start together. A directory that
/// cannot be written is ignored. Nothing throws but failed allocations.
class DiskCache {
 public:
  using Bytes = std::vector<unsigned char>;

  /// `directory` empty: no cache; nothing is read or written.
  explicit DiskCache(std::string directory) : m_directory(std::move(directory)) {}

  bool enabled() const { return !m_directory.empty(); }

  /// The bytes last written under this key, never empty; nothing if there is no intact entry.
  std::optional<Bytes> read(const std::string& key) const;

  /// Best effort: a full or read-only disk must not stop anybody from denoising. Empty `bytes` are not kept.
  void write(const std::string& key, const Bytes& bytes) const;

 private:
  std::string pathOf(const std::string& key) const;

  std::string m_directory;
};

}  // namespace quell
