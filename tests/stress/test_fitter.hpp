// What the tests of the stress suite share.
#pragma once

#include <cstdlib>
#include <cstring>

#include "host/stress/stress_suite.hpp"

namespace quell::stress {

/// The device of all tests, see tests/CMakeLists.txt; kernels are not kept on disk.
inline FitterOptions testOptions() {
  FitterOptions options;
  const char* device = std::getenv("QUELL_TEST_DEVICE");
  if (device != nullptr) options.device = device;
  options.options.cacheDirectory = "";
  return options;
}

inline BlockFitter& sharedFitter() {
  static BlockFitter fitter(testOptions());
  return fitter;
}

inline const Family& findFamily(const std::string& name) {
  for (const Family& family : families())
    if (family.name == name) return family;
  throw std::logic_error("no family " + name);
}

/// NaN equals NaN.
inline bool sameBits(const Batch& a, const Batch& b) {
  const std::size_t bytes = a.blocks.size() * sizeof(Block);
  return a.blocks.size() == b.blocks.size() && std::memcmp(a.blocks.data(), b.blocks.data(), bytes) == 0;
}

}  // namespace quell::stress
