// Frames that were captured (Options::captureDirectory), run once more: for bug reports.
#pragma once

#include <CL/cl.h>
#include <quell/api.h>

#include <cstdint>
#include <quell/denoiser.hpp>
#include <string>
#include <vector>

namespace quell {

/// One output image of a frame, when it was captured and now.
struct ReplayedOutput {
  std::string image;           ///< the member of Output
  std::uint64_t captured = 0;  ///< FNV-1a of 64 bits over its pixels, row by row from the top, without gaps
  std::uint64_t here = 0;      ///< the same of what this device has made
};

/// A frame that was run again.
struct ReplayedFrame {
  int number = 0;                       ///< from 0 on, in the order of the capture
  std::vector<ReplayedOutput> outputs;  ///< those that the capture has
};

/// Something that was not the same where the frames were captured.
struct FactDifference {
  std::string fact;      ///< for example "device" or "driver"
  std::string captured;  ///< what it was there
  std::string here;      ///< what it is here
};

/// One folder of a capture, run once more.
struct Replay {
  std::string directory;                    ///< the folder that was run
  std::string method;                       ///< the captured one, for example "quell"
  std::vector<ReplayedFrame> frames;        ///< in the order of the capture
  std::vector<FactDifference> differences;  ///< empty: device, driver and version are the same

  QUELL_API bool equal() const;  ///< all outputs, bit for bit
};

/// A line a frame, and what differs.
QUELL_API std::string toText(const Replay& replay);

/// Runs a captured folder, or all of them that lie in a folder, on this queue; blocks. Throws Error(FileError) for folders
/// that are not captures or are damaged, and what prepare() and denoise() throw.
QUELL_API std::vector<Replay> replay(const std::string& directory, cl_context context, cl_device_id device,
                                     cl_command_queue queue,
                                     const std::optional<std::string>& cacheDirectory = std::nullopt);

}  // namespace quell
