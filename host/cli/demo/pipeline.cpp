#include "host/cli/demo/pipeline.hpp"

#include "host/core/cl_error.hpp"
#include "host/render/path_tracer.hpp"
#include "host/render/pinhole_camera.hpp"

namespace quell::cli {
namespace {

constexpr char kStage[] = "demo";
constexpr int kOutputChannels = 3;

/// The denoiser reads the tracer's images where they are.
Frame frameOf(const render::TracedImages& traced, const DemoSetup& setup) {
  Frame frame;
  frame.size = setup.size;
  forEachInput(traced, frame, [](const ImageFacts& facts, const cl::Buffer& buffer, ImageView& view) {
    const bool ids = facts.files.samples == FileSamples::UINT;
    if (buffer() != nullptr)
      view = packedImage(buffer(), facts.fileChannels(),
                         ids ? ComponentFormat::UInt32 : ComponentFormat::Float32);
  });
  if (!setup.motion) frame.motion = frame.objectId = {};
  frame.demodulated = setup.signals == 2;
  if (frame.demodulated) {
    frame.radiance.memory = traced.diffuse();
  } else {
    frame.glossyRadiance = {};
  }
  return frame;
}

}  // namespace

class DemoPipeline::Implementation {
 public:
  explicit Implementation(const DemoSetup& setup)
      : m_setup(setup),
        m_scene(render::findScene(setup.scene)),
        m_info(chooseDevice(setup.device)),
        m_device(m_info.device, true),
        m_context(m_device),
        m_queue(m_context, m_device, CL_QUEUE_PROFILING_ENABLE),
        m_tracer(m_context, m_device, m_queue, setup.tracerCache, setup.size, true),
        m_denoiser(m_context, m_device, m_queue, setup.settings, setup.options),
        m_linear(makeOutput()),
        m_display(makeOutput()),
        m_frame(frameOf(m_tracer.images(), setup)),
        m_output{packedImage(m_linear(), kOutputChannels), packedImage(m_display(), kOutputChannels)} {
    m_denoiser.prepare(m_frame, m_output);
  }

  void enqueue(int frame) {
    const render::Scene now = render::makeScene(m_scene, frame),
                        before = render::makeScene(m_scene, frame - 1);
    m_tracer.traceFeatures(now, before);
    m_tracer.traceLight(render::mixSeed(m_setup.seed, frame, render::kNoisyStream), m_setup.samples);
    const Size size = m_setup.size;
    m_frame.camera.worldToClip = render::worldToClip(now.camera, size.width, size.height);
    m_frame.camera.worldToClipPrev = render::worldToClip(before.camera, size.width, size.height);
    m_denoiser.denoise(m_frame, m_output);
  }

  DemoPictures read() {
    return {read(m_tracer.images().radiance),
            {read(m_linear), read(m_display), displayTransform(m_denoiser.settings())}};
  }

  io::Reference reference(int frame, int samples) {
    // Apart from the tracer whose images the denoiser reads, and whose times are reported.
    if (!m_referenceTracer)
      m_referenceTracer.emplace(m_context, m_device, m_queue, m_setup.tracerCache, m_setup.size);
    m_referenceTracer->traceFeatures(render::makeScene(m_scene, frame),
                                     render::makeScene(m_scene, frame - 1));
    return {traceHalf(frame, 'a', samples), traceHalf(frame, 'b', samples)};
  }

  Timings tracingTimes() { return m_tracer.timings(); }
  Timings denoisingTimes() { return m_denoiser.timings(); }
  MemoryUse memoryUse() const { return m_denoiser.memoryUse(); }
  const DeviceInfo& device() const { return m_info; }

 private:
  cl::Buffer makeOutput() const {
    const std::size_t pixels =
        static_cast<std::size_t>(m_setup.size.width) * static_cast<std::size_t>(m_setup.size.height);
    return {m_context, CL_MEM_READ_WRITE, pixels * kOutputChannels * sizeof(float)};
  }

  io::Image traceHalf(int frame, char half, int samples) {
    m_referenceTracer->traceLight(render::mixSeed(m_setup.seed, frame, render::referenceStream(half)),
                                  samples);
    return read(m_referenceTracer->images().radiance);
  }

  io::Image read(const cl::Buffer& buffer) {
    io::Image image(m_setup.size.width, m_setup.size.height, kOutputChannels);
    m_queue.enqueueReadBuffer(buffer, CL_TRUE, 0, image.pixels.size() * sizeof(float), image.pixels.data());
    return image;
  }

  const DemoSetup m_setup;
  const render::SceneEntry& m_scene;
  const DeviceInfo m_info;
  cl::Device m_device;
  cl::Context m_context;
  cl::CommandQueue m_queue;
  render::DeviceTracer m_tracer;
  std::optional<render::DeviceTracer> m_referenceTracer;
  Denoiser m_denoiser;
  cl::Buffer m_linear;
  cl::Buffer m_display;
  Frame m_frame;
  Output m_output;
};

DemoPipeline::DemoPipeline(const DemoSetup& setup)
    : m_implementation(withClErrors(kStage, [&] { return std::make_unique<Implementation>(setup); })) {}

DemoPipeline::~DemoPipeline() = default;

void DemoPipeline::enqueue(int frame) {
  withClErrors(kStage, [&] { m_implementation->enqueue(frame); });
}

DemoPictures DemoPipeline::read() {
  return withClErrors(kStage, [&] { return m_implementation->read(); });
}

io::Reference DemoPipeline::reference(int frame, int samples) {
  return withClErrors(kStage, [&] { return m_implementation->reference(frame, samples); });
}

const DeviceInfo& DemoPipeline::device() const { return m_implementation->device(); }
Timings DemoPipeline::tracingTimes() {
  return withClErrors(kStage, [&] { return m_implementation->tracingTimes(); });
}
Timings DemoPipeline::denoisingTimes() {
  return withClErrors(kStage, [&] { return m_implementation->denoisingTimes(); });
}
MemoryUse DemoPipeline::memoryUse() const { return m_implementation->memoryUse(); }

}  // namespace quell::cli
