#include "host/render/device_tracer.hpp"

#include <algorithm>
#include <quell/error.hpp>
#include <vector>

#include "host/core/program_cache.hpp"
#include "host/core/round_up.hpp"
#include "host/render/kernel_sources.hpp"
#include "host/render/scene_arrays.hpp"

namespace quell::render {
namespace {

constexpr int kMaxExtentPx = 16384;
// Neighbouring rays take similar ways; small groups balance the cores.
constexpr std::size_t kGroupEdge = 8;
// Keeps one launch short: some GPUs stop kernels that run for seconds, and progress shows between launches.
constexpr int kSamplesPerLaunch = 8;

enum StageIndex : std::size_t { kPrimaryStage, kShadeStage, kComposeStage };

Size checked(Size size) {
  for (const int extent : {size.width, size.height}) {
    if (extent >= 1 && extent <= kMaxExtentPx) continue;
    throw Error(ErrorCode::InvalidArgument,
                {"render", "size", "width and height in [1, " + std::to_string(kMaxExtentPx) + "] pixels",
                 std::to_string(size.width) + "x" + std::to_string(size.height)});
  }
  return size;
}

// A whole number of work-groups.
std::size_t covering(int pixels) { return roundUp(static_cast<std::size_t>(pixels), kGroupEdge); }

}  // namespace

DeviceTracer::DeviceTracer(const cl::Context& context, const cl::Device& device,
                           const cl::CommandQueue& queue, const std::string& cacheDirectory, Size size,
                           bool timed)
    : m_size(checked(size)), m_context(context), m_device(device), m_queue(queue) {
  m_primary = build(cacheDirectory, "primary");
  m_shade = build(cacheDirectory, "shade");
  m_compose = build(cacheDirectory, "compose");
  for (const auto& image : kInputs<TracedImages>)
    if (image.hasFiles()) m_images.*image.member = makeBuffer(image.fileChannels());
  m_images.diffuse = makeBuffer(3);
  m_hits = makeBuffer(2);
  if (timed) startTimer();
}

void DeviceTracer::startTimer() {
  cl::Event event;
  m_queue.enqueueFillBuffer(m_images.radiance, 0.0f, 0, m_images.radiance.getInfo<CL_MEM_SIZE>(), nullptr,
                            &event);
  event.wait();
  const bool device = FrameTimer::hasDeviceTimes(event);
  m_timer = std::make_unique<FrameTimer>(std::vector<std::string>{"primary", "shade", "compose"},
                                         device ? TimeSource::Device : TimeSource::Host);
}

void DeviceTracer::traceFeatures(const Scene& now, const Scene& before) {
  uploadScene(now, before);
  const TracedImages& i = m_images;
  launch(kPrimaryStage, m_primary, m_nodes, m_primitives, m_materials, m_lights, i.positionWorld,
         i.normalWorld, i.albedo, i.glossColor, i.f0, i.emission, i.roughness, i.motion, i.objectId, m_hits,
         m_params);
}

void DeviceTracer::traceLight(std::uint32_t seed, int samples, Estimator estimator,
                              const SampleProgress& progress) {
  const TracedImages& i = m_images;
  for (const cl::Buffer* sum : {&i.diffuse, &i.glossyRadiance, &i.hitDistance})
    m_queue.enqueueFillBuffer(*sum, 0.0f, 0, sum->getInfo<CL_MEM_SIZE>());
  m_params.seed = seed;
  m_params.estimator = static_cast<int>(estimator);
  for (int first = 0; first < samples; first += kSamplesPerLaunch) {
    m_params.firstSample = first;
    m_params.sampleCount = std::min(kSamplesPerLaunch, samples - first);
    launch(kShadeStage, m_shade, m_nodes, m_primitives, m_materials, m_lights, m_hits, i.diffuse,
           i.glossyRadiance, i.hitDistance, m_params);
    if (!progress) continue;
    m_queue.finish();
    progress(m_params.sampleCount);
  }
  launch(kComposeStage, m_compose, i.albedo, i.glossColor, i.emission, i.diffuse, i.glossyRadiance,
         i.radiance, m_size.width, m_size.height, 1.0f / static_cast<float>(samples));
  if (m_timer) m_timer->endFrame();
}

cl::Kernel DeviceTracer::build(const std::string& cacheDirectory, const char* stem) const {
  const DeviceTraits traits = queryDeviceTraits(m_device, Mapping::Narrow);
  const cl::Program program = ProgramCache(cacheDirectory)
                                  .build(m_context, m_device, traits, stem, renderKernelSources().at(stem),
                                         "-cl-std=CL1.2 -D QUELL_LANES=1");
  return cl::Kernel(program, stem);
}

cl::Buffer DeviceTracer::makeBuffer(std::size_t components) const {
  const std::size_t pixels = static_cast<std::size_t>(m_size.width) * static_cast<std::size_t>(m_size.height);
  return {m_context, CL_MEM_READ_WRITE, components * sizeof(cl_float) * pixels};
}

template <class Value>
cl::Buffer DeviceTracer::upload(const std::vector<Value>& values) const {
  // An unlit scene still needs a buffer to name.
  std::vector<Value> copy = values;
  if (copy.empty()) copy.emplace_back();
  return {m_context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, copy.size() * sizeof(Value), copy.data()};
}

void DeviceTracer::uploadScene(const Scene& now, const Scene& before) {
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
void DeviceTracer::launch(std::size_t stage, cl::Kernel& kernel, const Arguments&... arguments) {
  cl_uint index = 0;
  (kernel.setArg(index++, arguments), ...);
  cl::Event event;
  m_queue.enqueueNDRangeKernel(kernel, cl::NullRange,
                               cl::NDRange(covering(m_size.width), covering(m_size.height)),
                               cl::NDRange(kGroupEdge, kGroupEdge), nullptr, m_timer ? &event : nullptr);
  if (m_timer) m_timer->add(stage, event);
}

}  // namespace quell::render
