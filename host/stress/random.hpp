// Random numbers that are the same on every machine: the standard library leaves its distributions open.
#pragma once

#include <cmath>
#include <cstdint>

namespace quell::stress {

/// SplitMix64 (Steele, Lea and Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : m_state(seed) {}

  std::uint64_t bits() {
    m_state += 0x9e3779b97f4a7c15ull;
    std::uint64_t z = m_state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double uniform() { return std::ldexp(static_cast<double>(bits() >> 11), -53); }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Its logarithm is uniform.
  double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  /// In [low, high].
  int integer(int low, int high) { return low + static_cast<int>(uniform() * (high - low + 1)); }
  bool chance(double probability) { return uniform() < probability; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }

 private:
  std::uint64_t m_state;
};

}  // namespace quell::stress
