#include "host/render/path_tracer.hpp"

#include <algorithm>
#include <quell/devices.hpp>
#include <quell/error.hpp>
#include <utility>
#include <vector>

#include "host/core/cl_error.hpp"
#include "host/core/program_cache.hpp"
#include "host/render/kernel_sources.hpp"
#include "host/render/scene_arrays.hpp"

namespace quell::render {
namespace {

constexpr char kStage[] = "render";
constexpr int kMaxExtentPx = 16384;
// Neighbouring rays take similar ways; small groups balance the cores.
constexpr std::size_t kGroupEdge = 8;
// Keeps one launch short: some GPUs stop kernels that run for seconds, and progress shows between launches.
constexpr int kSamplesPerLaunch = 8;

// PCG hash, as in kernels/common/random.h.
std::uint32_t hash(std::uint32_t v) {
  const std::uint32_t state = v * 747796405u + 2891336453u;
  const std::uint32_t word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

std::size_t roundUp(int pixels) {
  return (static_cast<std::size_t>(pixels) + kGroupEdge - 1) / kGroupEdge * kGroupEdge;
}

void scale(io::Image& image, float factor) {
  for (float& value : image.pixels) value *= factor;
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

class PathTracer::Implementation {
 public:
  Implementation(const std::string& deviceSpec, const std::string& cacheDirectory, Size size)
      : m_info(chooseDevice(deviceSpec)),
        m_size(size),
        m_device(m_info.device, true),
        m_context(m_device),
        m_queue(m_context, m_device) {
    const ProgramCache cache(cacheDirectory);
    m_primary = build(cache, "primary");
    m_shade = build(cache, "shade");
    for (cl::Buffer* image :
         {&m_position, &m_normal, &m_albedo, &m_glossColor, &m_f0, &m_emission, &m_diffuse, &m_glossy})
      *image = makeBuffer(3);
    for (cl::Buffer* image : {&m_motion, &m_hits}) *image = makeBuffer(2);
    for (cl::Buffer* image : {&m_roughness, &m_objectId, &m_hitDistance}) *image = makeBuffer(1);
  }

  Features features(const Scene& now, const Scene& before) {
    uploadScene(now, before);
    launch(m_primary, m_nodes, m_primitives, m_materials, m_lights, m_position, m_normal, m_albedo,
           m_glossColor, m_f0, m_emission, m_roughness, m_motion, m_objectId, m_hits, m_params);
    Features features;
    features.position = read(m_position, 3);
    features.normal = read(m_normal, 3);
    features.albedo = read(m_albedo, 3);
    features.glossColor = read(m_glossColor, 3);
    features.f0 = read(m_f0, 3);
    features.emission = read(m_emission, 3);
    features.roughness = read(m_roughness, 1);
    features.motion = read(m_motion, 2);
    features.objectId = readIds();
    return features;
  }

  Light light(std::uint32_t seed, int samples, Estimator estimator,
              const std::function<void(int)>& progress) {
    for (cl::Buffer* sum : {&m_diffuse, &m_glossy, &m_hitDistance})
      m_queue.enqueueFillBuffer(*sum, 0.0f, 0, sum->getInfo<CL_MEM_SIZE>());
    m_params.seed = seed;
    m_params.estimator = static_cast<int>(estimator);
    for (int first = 0; first < samples; first += kSamplesPerLaunch) {
      m_params.firstSample = first;
      m_params.sampleCount = std::min(kSamplesPerLaunch, samples - first);
      launch(m_shade, m_nodes, m_primitives, m_materials, m_lights, m_hits, m_diffuse, m_glossy,
             m_hitDistance, m_params);
      m_queue.finish();
      if (progress) progress(m_params.sampleCount);
    }
    Light light;
    light.diffuse = read(m_diffuse, 3);
    light.glossy = read(m_glossy, 3);
    light.hitDistance = read(m_hitDistance, 1);
    scale(light.diffuse, 1.0f / static_cast<float>(samples));
    scale(light.glossy, 1.0f / static_cast<float>(samples));
    return light;
  }

  const std::string& deviceName() const { return m_info.name; }

 private:
  cl::Kernel build(const ProgramCache& cache, const char* stem) const {
    const DeviceTraits traits = queryDeviceTraits(m_device, Mapping::Narrow);
    const cl::Program program = cache.build(m_context, m_device, traits, stem, renderKernelSources().at(stem),
                                            "-cl-std=CL1.2 -D QUELL_LANES=1");
    return cl::Kernel(program, stem);
  }

  cl::Buffer makeBuffer(std::size_t components) const {
    return {m_context, CL_MEM_READ_WRITE, bytes(components)};
  }

  /// Of an image of 32-bit components.
  std::size_t bytes(std::size_t components) const {
    return components * 4 * static_cast<std::size_t>(m_size.width) * static_cast<std::size_t>(m_size.height);
  }

  template <class Value>
  cl::Buffer upload(const std::vector<Value>& values) const {
    // An unlit scene still needs a buffer to name.
    std::vector<Value> copy = values;
    if (copy.empty()) copy.emplace_back();
    return {m_context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, copy.size() * sizeof(Value), copy.data()};
  }

  void uploadScene(const Scene& now, const Scene& before) {
    const SceneArrays arrays = makeSceneArrays(now, before);
    m_nodes = upload(arrays.nodes);
    m_primitives = upload(arrays.primitives);
    m_materials = upload(arrays.materials);
    m_lights = upload(arrays.lights);
    m_params = {};
    m_params.camera = makeRenderCamera(now.camera, m_size.width, m_size.height);
    m_params.cameraPrev = makeRenderCamera(before.camera, m_size.width, m_size.height);
    m_params.sky = arrays.sky;
    m_params.width = m_size.width;
    m_params.height = m_size.height;
    m_params.lightCount = static_cast<int>(arrays.lights.size());
    m_params.skyLight = arrays.skyLight;
    m_params.sunLight = arrays.sunLight;
    m_params.pixelAngle = static_cast<float>(pixelAngle(now.camera, m_size.height));
  }

  template <class... Arguments>
  void launch(cl::Kernel& kernel, const Arguments&... arguments) {
    cl_uint index = 0;
    (kernel.setArg(index++, arguments), ...);
    m_queue.enqueueNDRangeKernel(kernel, cl::NullRange,
                                 cl::NDRange(roundUp(m_size.width), roundUp(m_size.height)),
                                 cl::NDRange(kGroupEdge, kGroupEdge));
  }

  io::Image read(const cl::Buffer& buffer, int channels) {
    io::Image image(m_size.width, m_size.height, channels);
    m_queue.enqueueReadBuffer(buffer, CL_TRUE, 0, image.pixels.size() * sizeof(float), image.pixels.data());
    return image;
  }

  io::Image readIds() {
    io::Image image(m_size.width, m_size.height, 1);
    std::vector<cl_int> ids(image.pixels.size());
    m_queue.enqueueReadBuffer(m_objectId, CL_TRUE, 0, ids.size() * sizeof(cl_int), ids.data());
    std::transform(ids.begin(), ids.end(), image.pixels.begin(),
                   [](cl_int id) { return static_cast<float>(id); });
    return image;
  }

  DeviceInfo m_info;
  Size m_size;
  cl::Device m_device;
  cl::Context m_context;
  cl::CommandQueue m_queue;
  cl::Kernel m_primary, m_shade;
  cl::Buffer m_nodes, m_primitives, m_materials, m_lights;
  cl::Buffer m_position, m_normal, m_albedo, m_glossColor, m_f0, m_emission, m_roughness, m_motion,
      m_objectId;
  cl::Buffer m_hits, m_diffuse, m_glossy, m_hitDistance;
  RenderParams m_params{};
};

PathTracer::PathTracer(const std::string& device, const std::string& cacheDirectory, Size size) {
  for (const int extent : {size.width, size.height}) {
    if (extent >= 1 && extent <= kMaxExtentPx) continue;
    throw Error(ErrorCode::InvalidArgument,
                {kStage, "size", "width and height in [1, " + std::to_string(kMaxExtentPx) + "] pixels",
                 std::to_string(size.width) + "x" + std::to_string(size.height)});
  }
  m_implementation =
      withClErrors(kStage, [&] { return std::make_unique<Implementation>(device, cacheDirectory, size); });
}

PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;
PathTracer::~PathTracer() = default;

Features PathTracer::features(const Scene& now, const Scene& before) {
  return withClErrors(kStage, [&] { return m_implementation->features(now, before); });
}

Light PathTracer::light(std::uint32_t seed, int samples, Estimator estimator,
                        const std::function<void(int)>& progress) {
  return withClErrors(kStage, [&] { return m_implementation->light(seed, samples, estimator, progress); });
}

const std::string& PathTracer::deviceName() const { return m_implementation->deviceName(); }

}  // namespace quell::render
