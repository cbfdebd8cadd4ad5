#include "host/cli/bench/build_times.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <random>

#include "host/cli/common/denoise_session.hpp"
#include "host/core/program_cache.hpp"

namespace quell::cli {
namespace {

/// A cache directory that nobody else knows, and sources that no compiler has seen.
class UnknownKernels {
 public:
  UnknownKernels() {
    const std::string unique =
        fmt::format("quell-build-{:08x}{:08x}", std::random_device()(), std::random_device()());
    m_directory = std::filesystem::temp_directory_path() / unique;
    ProgramCache::setSourceComment(unique);
  }
  ~UnknownKernels() {
    ProgramCache::setSourceComment("");
    std::error_code ignored;  // what is left in a temporary directory harms nobody
    std::filesystem::remove_all(m_directory, ignored);
  }
  UnknownKernels(const UnknownKernels&) = delete;
  UnknownKernels& operator=(const UnknownKernels&) = delete;

  std::string directory() const { return m_directory.string(); }

 private:
  std::filesystem::path m_directory;
};

double prepareMs(const Settings& settings, const DeviceArguments& device, const Options& options,
                 const io::FrameData& example) {
  ProgramCache::clearMemory();
  const auto begin = std::chrono::steady_clock::now();
  const DenoiseSession session(device.device, settings, options, example);
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

BuildTimes measureBuildTimes(const Settings& settings, const DeviceArguments& device,
                             const io::FrameData& example) {
  const UnknownKernels unknown;
  Options options = makeOptions(device, TimerMode::Off);
  options.cacheDirectory = unknown.directory();
  BuildTimes times;
  times.coldMs = prepareMs(settings, device, options, example);
  times.cachedMs = prepareMs(settings, device, options, example);
  return times;
}

}  // namespace quell::cli
