#include "host/render/path_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <quell/devices.hpp>
#include <utility>
#include <vector>

#include "host/core/cl_error.hpp"
#include "host/io/halton.hpp"

namespace quell::render {
namespace {

constexpr char kStage[] = "render";

bool isLight(cl::Buffer TracedImages::*image) {
  return image == &TracedImages::radiance || image == &TracedImages::glossyRadiance ||
         image == &TracedImages::hitDistance;
}

// As many as go with one launch of the tracer: more places cost time, fewer leave steps in edges.
constexpr int kSamplesPerPlace = 8;

// PCG hash, as in kernels/common/random.h.
std::uint32_t hash(std::uint32_t v) {
  const std::uint32_t state = v * 747796405u + 2891336453u;
  const std::uint32_t word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

// Offset from the pixel centre, pixels: the Halton sequence, shifted so that two seeds share no place.
std::array<double, 2> placeInPixel(int place, std::uint32_t seed) {
  std::array<double, 2> offset = io::halton23(place + 1);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double shift = double(hash(seed + std::uint32_t(axis))) * 0x1p-32;
    offset[axis] = std::fmod(offset[axis] + shift, 1.0) - 0.5;
  }
  return offset;
}

}  // namespace

std::uint32_t mixSeed(std::uint32_t seed, int frame, int stream) {
  return hash(static_cast<std::uint32_t>(stream) + hash(static_cast<std::uint32_t>(frame) + hash(seed)));
}

io::Image composeColor(const Features& features, const Light& light) {
  io::Image color = features.emission;
  for (std::size_t i = 0; i < color.pixels.size(); ++i)
    color.pixels[i] += features.albedo.pixels[i] * light.diffuse.pixels[i] +
                       features.glossColor.pixels[i] * light.glossy.pixels[i];
  return color;
}

io::FrameData withLight(const Features& features, const Light& light) {
  io::FrameData data = features;
  data.radiance = light.diffuse;
  data.glossyRadiance = light.glossy;
  data.hitDistance = light.hitDistance;
  data.combined = composeColor(features, light);
  return data;
}

class PathTracer::Implementation {
 public:
  Implementation(const std::string& deviceSpec, const std::string& cacheDirectory, Size size)
      : m_info(chooseDevice(deviceSpec)),
        m_size(size),
        m_device(m_info.device, true),
        m_context(m_device),
        m_queue(m_context, m_device),
        m_tracer(m_context, m_device, m_queue, cacheDirectory, size) {}

  Features features(const Scene& now, const Scene& before) {
    m_tracer.traceFeatures(now, before);
    const TracedImages& traced = m_tracer.images();
    Features features;
    for (std::size_t i = 0; i < std::size(kInputs<TracedImages>); ++i) {
      const auto& image = kInputs<TracedImages>[i];
      if (image.hasFiles() && !isLight(image.member))
        features.*kInputs<Features>[i].member = read(traced.*image.member, image);
    }
    return features;
  }

  Light light(std::uint32_t seed, int samples, Estimator estimator, const SampleProgress& progress) {
    m_tracer.traceLight(seed, samples, estimator, progress);
    const TracedImages& traced = m_tracer.images();
    return {read(traced.diffuse, 3), read(traced.glossyRadiance, 3), read(traced.hitDistance, 1)};
  }

  io::Image antialiased(Scene now, Scene before, std::uint32_t seed, int samples,
                        const SampleProgress& progress) {
    io::Image mean(m_size.width, m_size.height, 3);
    for (int first = 0, place = 0; first < samples; first += kSamplesPerPlace, ++place) {
      const int count = std::min(kSamplesPerPlace, samples - first);
      now.camera.jitterPx = before.camera.jitterPx = placeInPixel(place, seed);
      m_tracer.traceFeatures(now, before);
      m_tracer.traceLight(mixSeed(seed, place, kNoisyStream), count, Estimator::Both, progress);
      const io::Image picture = read(m_tracer.images().radiance, 3);
      for (std::size_t i = 0; i < mean.pixels.size(); ++i)
        mean.pixels[i] += picture.pixels[i] * (float(count) / float(samples));
    }
    return mean;
  }

  const std::string& deviceName() const { return m_info.name; }

 private:
  io::Image read(const cl::Buffer& buffer, int channels) {
    io::Image image(m_size.width, m_size.height, channels);
    m_queue.enqueueReadBuffer(buffer, CL_TRUE, 0, image.pixels.size() * sizeof(float), image.pixels.data());
    return image;
  }

  io::Image read(const cl::Buffer& buffer, const ImageFacts& facts) {
    return facts.files.samples == FileSamples::UINT ? readIds(buffer) : read(buffer, facts.fileChannels());
  }

  io::Image readIds(const cl::Buffer& buffer) {
    io::Image image(m_size.width, m_size.height, 1);
    std::vector<cl_int> ids(image.pixels.size());
    m_queue.enqueueReadBuffer(buffer, CL_TRUE, 0, ids.size() * sizeof(cl_int), ids.data());
    std::transform(ids.begin(), ids.end(), image.pixels.begin(),
                   [](cl_int id) { return static_cast<float>(id); });
    return image;
  }

  DeviceInfo m_info;
  Size m_size;
  cl::Device m_device;
  cl::Context m_context;
  cl::CommandQueue m_queue;
  DeviceTracer m_tracer;
};

PathTracer::PathTracer(const std::string& device, const std::string& cacheDirectory, Size size)
    : m_implementation(withClErrors(
          kStage, [&] { return std::make_unique<Implementation>(device, cacheDirectory, size); })) {}

PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;
PathTracer::~PathTracer() = default;

Features PathTracer::features(const Scene& now, const Scene& before) {
  return withClErrors(kStage, [&] { return m_implementation->features(now, before); });
}

Light PathTracer::light(std::uint32_t seed, int samples, Estimator estimator,
                        const SampleProgress& progress) {
  return withClErrors(kStage, [&] { return m_implementation->light(seed, samples, estimator, progress); });
}

io::Image PathTracer::antialiased(Scene now, Scene before, std::uint32_t seed, int samples,
                                  const SampleProgress& progress) {
  return withClErrors(kStage, [&] {
    return m_implementation->antialiased(std::move(now), std::move(before), seed, samples, progress);
  });
}

const std::string& PathTracer::deviceName() const { return m_implementation->deviceName(); }

}  // namespace quell::render
