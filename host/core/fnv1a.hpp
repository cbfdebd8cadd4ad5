// FNV-1a, 64 bits (Fowler, Noll, Vo): a quick hash that is the same everywhere; not for what somebody could forge.
#pragma once

#include <cstddef>
#include <cstdint>

namespace quell {

/// Of no bytes.
constexpr std::uint64_t kFnv1aStart = 0xcbf29ce484222325ull;

/// `hash` of the bytes so far, with `size` more.
inline std::uint64_t fnv1a(const void* data, std::size_t size, std::uint64_t hash = kFnv1aStart) {
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3ull;
  return hash;
}

}  // namespace quell
