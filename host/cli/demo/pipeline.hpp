// A renderer with a denoiser in it: traces and denoises on one context and queue, all images stay on the device.
#pragma once

#include <memory>
#include <optional>
#include <quell/quell.hpp>
#include <string>

#include "host/cli/common/denoise_session.hpp"
#include "host/io/frame_sequence.hpp"
#include "host/render/device_tracer.hpp"
#include "host/render/scene_registry.hpp"

namespace quell::cli {

struct DemoSetup {
  std::string scene;
  Size size;
  int samples = 1;  ///< per pixel
  std::uint32_t seed = 1;
  int signals = 1;          ///< 2: diffuse and glossy light side by side
  bool motion = true;       ///< motion vectors and object ids reach the denoiser
  std::string device;       ///< as for chooseDevice()
  std::string tracerCache;  ///< for the path tracer's compiled kernels; empty: none
  Settings settings;
  Options options;
};

/// Pictures of one frame, float, 3 channels.
struct DemoPictures {
  io::Image noisy;  ///< linear
  DenoisedFrame denoised;
};

class DemoPipeline {
 public:
  /// Builds everything. Throws quell::Error, for an unknown scene among others.
  explicit DemoPipeline(const DemoSetup& setup);
  ~DemoPipeline();

  /// Enqueues tracing and denoising of a frame; nothing comes back to the host. Frames must be in order.
  void enqueue(int frame);

  /// Waits for the latest frame and copies its pictures to the host.
  DemoPictures read();

  /// Both halves of the reference of a frame through pixel centres, with that many samples per pixel each; blocks.
  io::Reference reference(int frame, int samples);

  const DeviceInfo& device() const;
  Timings tracingTimes();
  Timings denoisingTimes();
  MemoryUse memoryUse() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

}  // namespace quell::cli
