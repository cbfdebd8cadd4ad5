// The path tracer with images in host memory: one frame of a scene at a time, on any OpenCL device.
#pragma once

#include <cstdint>
#include <memory>
#include <quell/frame.hpp>
#include <string>

#include "host/io/frame_sequence.hpp"
#include "host/render/device_tracer.hpp"
#include "host/render/scene.hpp"

namespace quell::render {

/// The images of a frame that the primary rays see, free of noise: all that have files, but light. All zero (but emission
/// and motion) where a ray leaves the scene.
using Features = io::FrameData;

/// Means over samples.
struct Light {
  io::Image diffuse;  ///< 3 channels: color = albedo * diffuse + glossColor * glossy + emission
  io::Image glossy;   ///< 3 channels, Fresnel included
  /// 1 channel, m: how far the first secondary ray of the GGX lobe went; QUELL_NO_HIT_DISTANCE,
  /// QUELL_MISS_DISTANCE.
  io::Image hitDistance;
};

/// albedo * diffuse + glossColor * glossy + emission.
io::Image composeColor(const Features& features, const Light& light);

/// A frame of two signals.
io::FrameData withLight(const Features& features, const Light& light);

/// Streams of random numbers: noisy frames and both halves ('a' and 'b') of both kinds of reference are independent.
constexpr int kNoisyStream = 0;
constexpr int referenceStream(char half, io::ReferenceKind kind = io::ReferenceKind::Centre) {
  return (half == 'a' ? 1 : 2) + (kind == io::ReferenceKind::Centre ? 0 : 2);
}

/// A seed of its own for every frame and stream.
std::uint32_t mixSeed(std::uint32_t seed, int frame, int stream);

/// Equal arguments give equal pixels on one device and driver. Errors of OpenCL come as quell::Error.
class PathTracer {
 public:
  /// `device` as for chooseDevice(); `cacheDirectory` for compiled kernels, empty: none. Builds the kernels.
  /// Throws Error(InvalidArgument) unless width and height are in [1, 16384].
  PathTracer(const std::string& device, const std::string& cacheDirectory, Size size);
  PathTracer(PathTracer&&) noexcept;
  PathTracer& operator=(PathTracer&&) noexcept;
  ~PathTracer();

  /// Traces the primary rays of a scene; `before` is the scene one frame earlier.
  Features features(const Scene& now, const Scene& before);

  /// The light of the scene last given to features(); samples >= 1 per pixel. `progress` is called with the
  /// number of samples just done.
  Light light(std::uint32_t seed, int samples, Estimator estimator = Estimator::Both,
              const SampleProgress& progress = {});

  /// The picture antialiased over the pixel (box filter, 1 px), 3 channels, linear: samples >= 1 per pixel, at
  /// places inside it that change every few samples; the cameras' own jitter does not count.
  io::Image antialiased(Scene now, Scene before, std::uint32_t seed, int samples,
                        const SampleProgress& progress = {});

  const std::string& deviceName() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

}  // namespace quell::render
