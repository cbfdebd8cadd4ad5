// Compiled programs: built once per process and device, kept on disk as binaries.
#pragma once

#include <memory>
#include <string>

#include "host/core/device_traits.hpp"
#include "host/core/disk_cache.hpp"
#include "host/core/opencl.hpp"

namespace quell {

/// How many programs came from where since the process started.
struct ProgramCacheCounters {
  int built = 0;       ///< compiled from source
  int fromMemory = 0;  ///< from a binary built or read earlier in this process
  int fromDisk = 0;    ///< from the cache directory
};

using SharedProgram = std::shared_ptr<const cl::Program>;

/// Thread-safe. A program's key is device, driver, options and source; entries on disk are those of a DiskCache.
class ProgramCache {
 public:
  /// `directory` empty: no disk cache. Devices that compile for binaries (DeviceTraits) have one, on disk and in memory, only
  /// with a directory and `costlyBinaries`.
  explicit ProgramCache(std::string directory, bool costlyBinaries = true)
      : m_disk(std::move(directory)), m_costlyBinaries(costlyBinaries) {}

  /// Throws Error(BuildFailed) with the build log; `stage` names the culprit.
  cl::Program build(const cl::Context& context, const cl::Device& device, const DeviceTraits& traits,
                    const std::string& stage, const std::string& source, const std::string& options) const;

  /// The same; as long as somebody holds it, everybody in the context gets the one program.
  SharedProgram share(const cl::Context& context, const cl::Device& device, const DeviceTraits& traits,
                      const std::string& stage, const std::string& source, const std::string& options) const;

  /// Whether build() would compile nothing.
  bool has(const DeviceTraits& traits, const std::string& source, const std::string& options) const;

  /// Where programs are kept from one process to the next, for other results that belong beside them.
  const DiskCache& disk() const { return m_disk; }

  static ProgramCacheCounters counters();
  /// Drops the binaries held in memory (not those on disk).
  static void clearMemory();
  /// A comment that is added to every source compiled from now on: a text that was never used makes compilers with
  /// caches of their own start cold. For measurements; must be called while nothing is built.
  static void setSourceComment(const std::string& text);

 private:
  DiskCache m_disk;
  bool m_costlyBinaries;
};

/// $XDG_CACHE_HOME/quell, else $HOME/.cache/quell, else empty.
std::string defaultCacheDirectory();

}  // namespace quell
