// How long it takes until a denoiser is ready.
#pragma once

#include <quell/quell.hpp>

#include "host/cli/common/command_arguments.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// Times from a device to a prepared denoiser, milliseconds: kernels built, memory allocated, every kernel launched once.
struct BuildTimes {
  double coldMs = 0.0;    ///< with all kernels unknown, to the driver's own cache, too
  double cachedMs = 0.0;  ///< with the kernels in the cache directory, in a new process
};

/// Uses a cache directory of its own, which is removed. Throws quell::Error.
BuildTimes measureBuildTimes(const Settings& settings, const DeviceArguments& device,
                             const io::FrameData& example);

}  // namespace quell::cli
