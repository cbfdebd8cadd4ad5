// The path tracer on the device: images stay in buffers, for whoever reads them there.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <quell/image_view.hpp>
#include <quell/timings.hpp>
#include <string>

#include "host/core/frame_timer.hpp"
#include "host/core/image_schema.hpp"
#include "host/core/opencl.hpp"
#include "host/render/scene.hpp"

namespace quell::render {

/// Packed row-major images: the picture as `radiance`, and with the number of channels of their files all images of the
/// contract that have files (quell/frame_images.h), float, object ids 32-bit integers. More is said at Features and
/// Light (path_tracer.hpp).
struct TracedImages {
#define QUELL_BUFFER(name, ...) cl::Buffer name;
  QUELL_FRAME_IMAGES(QUELL_BUFFER)
#undef QUELL_BUFFER
  cl::Buffer diffuse;  ///< 3 channels: radiance = albedo * diffuse + glossColor * glossyRadiance + emission
};

/// Which of the two estimates of direct light counts; one alone is for tests.
enum class Estimator {
  Both = QUELL_ESTIMATOR_BOTH,
  LightOnly = QUELL_ESTIMATOR_LIGHT_ONLY,
  BsdfOnly = QUELL_ESTIMATOR_BSDF_ONLY,
};

/// Called with the number of samples per pixel just done.
using SampleProgress = std::function<void(int)>;

/// Traces on a queue of the caller's, which must be in-order. Equal arguments give equal pixels on one device
/// and driver. Errors of OpenCL come as cl::Error.
class DeviceTracer {
 public:
  /// Builds the kernels; `cacheDirectory` for compiled ones, empty: none. With `timed`, the queue must have
  /// CL_QUEUE_PROFILING_ENABLE. Throws Error(InvalidArgument) unless width and height are in [1, 16384].
  DeviceTracer(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue,
               const std::string& cacheDirectory, Size size, bool timed = false);

  /// Enqueues the primary rays of a scene; `before` is the scene one frame earlier.
  void traceFeatures(const Scene& now, const Scene& before);

  /// Enqueues the light of the scene last given to traceFeatures(), samples >= 1 per pixel, and the picture.
  /// Blocks only with `progress`, to tell it about each launch.
  void traceLight(std::uint32_t seed, int samples, Estimator estimator = Estimator::Both,
                  const SampleProgress& progress = {});

  const TracedImages& images() const { return m_images; }

  /// Times of all frames that have finished so far, per kernel; never waits. Empty unless `timed`. Bytes are not
  /// counted.
  Timings timings() { return m_timer ? m_timer->collect() : Timings{}; }

 private:
  cl::Kernel build(const std::string& cacheDirectory, const char* stem) const;
  cl::Buffer makeBuffer(std::size_t components) const;
  template <class Value>
  cl::Buffer upload(const std::vector<Value>& values) const;
  void startTimer();
  void uploadScene(const Scene& now, const Scene& before);
  template <class... Arguments>
  void launch(std::size_t stage, cl::Kernel& kernel, const Arguments&... arguments);

  Size m_size;
  cl::Context m_context;
  cl::Device m_device;
  cl::CommandQueue m_queue;
  cl::Kernel m_primary, m_shade, m_compose;
  cl::Buffer m_nodes, m_primitives, m_materials, m_lights;
  cl::Buffer m_hits;
  TracedImages m_images;
  RenderParams m_params{};
  std::unique_ptr<FrameTimer> m_timer;
};

}  // namespace quell::render
