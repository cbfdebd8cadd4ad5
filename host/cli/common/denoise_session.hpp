// A denoiser with buffers for frames that come from host memory: what a tool needs around the library.
#pragma once

#include <cstdint>
#include <memory>
#include <quell/quell.hpp>
#include <string>

#include "host/core/display_transform.hpp"
#include "host/core/fnv1a.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// What settings of a method make of light for display.
DisplayTransform displayTransform(const Settings& settings);

/// Both outputs of one frame, float, 3 channels.
struct DenoisedFrame {
  io::Image linear;
  io::Image display;
  DisplayTransform transform = {};  ///< what made `display` of light
};

/// Whether motion vectors and object ids of a sequence reach the denoiser.
enum class MotionUse { WherePresent, Never };

class DenoiseSession {
 public:
  /// Opens a device of its own (`deviceSpec` as for chooseDevice) and prepares a denoiser for frames that
  /// look like `example`. Throws quell::Error.
  DenoiseSession(const std::string& deviceSpec, const Settings& settings, const Options& options,
                 const io::FrameData& example, MotionUse motion = MotionUse::WherePresent);
  ~DenoiseSession();

  /// Uploads, denoises and downloads; blocks. A frame that repeats noise or follows a gap is denoised
  /// without history.
  DenoisedFrame denoise(const io::FrameData& frame);
  /// Uploads and denoises, but leaves the outputs on the device; blocks. For timing.
  void run(const io::FrameData& frame);

  /// The denoiser's times.
  Timings timings();

  const DeviceInfo& device() const;
  Denoiser& denoiser();
  cl_context context() const;
  cl_device_id deviceId() const;
  cl_command_queue queue() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

/// FNV-1a of 64 bits over the bytes of the outputs of a sequence, in order: equal hashes mean bit-identical
/// output.
class OutputHash {
 public:
  void add(const io::Image& image);
  std::string text() const;  ///< 16 hexadecimal digits

 private:
  std::uint64_t m_hash = kFnv1aStart;
};

}  // namespace quell::cli
