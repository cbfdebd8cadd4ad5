#include "host/cli/common/denoise_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "host/core/cl_error.hpp"
#include "host/methods/method.hpp"

namespace quell::cli {
namespace {

constexpr int kOutputChannels = 3;

// One input image on the device.
struct InputImage {
  io::Image io::FrameData::*source;
  ImageView Frame::*view;
};

std::vector<InputImage> usedInputs(MotionUse motion) {
  std::vector<InputImage> inputs;
  for (std::size_t i = 0; i < std::size(kInputs<Frame>); ++i) {
    const auto source = kInputs<io::FrameData>[i].member;
    const bool isMotion = source == &io::FrameData::motion || source == &io::FrameData::objectId;
    if (motion == MotionUse::WherePresent || !isMotion) inputs.push_back({source, kInputs<Frame>[i].member});
  }
  return inputs;
}

std::size_t bytesOf(const io::Image& image) { return image.pixels.size() * sizeof(float); }

}  // namespace

DisplayTransform displayTransform(const Settings& settings) {
  return findMethod(settings.method()).runtimeSettings(settings).display;
}

class DenoiseSession::Implementation {
 public:
  Implementation(const std::string& deviceSpec, const Settings& settings, const Options& options,
                 const io::FrameData& example, MotionUse motion)
      : m_inputs(usedInputs(motion)),
        m_info(chooseDevice(deviceSpec)),
        m_device(m_info.device, true),
        m_context(m_device),
        m_queue(
            m_context, m_device,
            options.timers == TimerMode::Device ? CL_QUEUE_PROFILING_ENABLE : cl_command_queue_properties{0}),
        m_denoiser(m_context(), m_device(), m_queue(), settings, options) {
    m_frame.size = {example.radiance.width, example.radiance.height};
    m_frame.demodulated = example.demodulated;
    for (const InputImage& input : m_inputs) {
      const io::Image& image = example.*input.source;
      if (image.empty()) continue;
      m_buffers.emplace_back(m_context, CL_MEM_READ_ONLY, bytesOf(image));
      m_frame.*input.view = packedImage(m_buffers.back()(), image.channels);
    }
    m_output.linear = makeOutput();
    m_output.display = makeOutput();
    m_denoiser.prepare(m_frame, m_output);
  }

  void run(const io::FrameData& data) {
    for (const InputImage& input : m_inputs) upload(data.*input.source, m_frame.*input.view, data);
    m_frame.camera = data.camera;
    if (data.repeatsNoise || data.afterGap) m_denoiser.resetHistory();
    const Event done = m_denoiser.denoise(m_frame, m_output);
    done.wait();
  }

  DenoisedFrame denoise(const io::FrameData& data) {
    run(data);
    return {download(m_output.linear), download(m_output.display), displayTransform(m_denoiser.settings())};
  }

  const std::vector<InputImage> m_inputs;
  const DeviceInfo m_info;
  cl::Device m_device;
  cl::Context m_context;
  cl::CommandQueue m_queue;
  Denoiser m_denoiser;

 private:
  ImageView makeOutput() {
    const std::size_t pixels =
        static_cast<std::size_t>(m_frame.size.width) * static_cast<std::size_t>(m_frame.size.height);
    m_buffers.emplace_back(m_context, CL_MEM_WRITE_ONLY, pixels * kOutputChannels * sizeof(float));
    return packedImage(m_buffers.back()(), kOutputChannels);
  }

  void upload(const io::Image& image, const ImageView& view, const io::FrameData& data) {
    if (image.empty() != !view.present() || (view.present() && (image.channels != view.channels))) {
      throw Error(ErrorCode::InvalidArgument, {"denoise", fmt::format("frame {}", data.number),
                                               "the same buffers as the first frame", "others"});
    }
    if (!view.present()) return;
    if (image.width != m_frame.size.width || image.height != m_frame.size.height) {
      throw Error(ErrorCode::InvalidArgument, {"denoise", fmt::format("frame {}", data.number),
                                               fmt::format("{}x{}", m_frame.size.width, m_frame.size.height),
                                               fmt::format("{}x{}", image.width, image.height)});
    }
    m_queue.enqueueWriteBuffer(cl::Buffer(view.memory, true), CL_TRUE, 0, bytesOf(image),
                               image.pixels.data());
  }

  io::Image download(const ImageView& view) {
    io::Image image(m_frame.size.width, m_frame.size.height, kOutputChannels);
    m_queue.enqueueReadBuffer(cl::Buffer(view.memory, true), CL_TRUE, 0, bytesOf(image), image.pixels.data());
    return image;
  }

  std::vector<cl::Buffer> m_buffers;
  Frame m_frame;
  Output m_output;
};

DenoiseSession::DenoiseSession(const std::string& deviceSpec, const Settings& settings,
                               const Options& options, const io::FrameData& example, MotionUse motion)
    : m_implementation(withClErrors("denoise", [&] {
        return std::make_unique<Implementation>(deviceSpec, settings, options, example, motion);
      })) {}

DenoiseSession::~DenoiseSession() = default;

DenoisedFrame DenoiseSession::denoise(const io::FrameData& frame) {
  return withClErrors("denoise", [&] { return m_implementation->denoise(frame); });
}

void DenoiseSession::run(const io::FrameData& frame) {
  withClErrors("denoise", [&] { m_implementation->run(frame); });
}

Timings DenoiseSession::timings() { return denoiser().timings(); }

const DeviceInfo& DenoiseSession::device() const { return m_implementation->m_info; }
Denoiser& DenoiseSession::denoiser() { return m_implementation->m_denoiser; }
cl_context DenoiseSession::context() const { return m_implementation->m_context(); }
cl_device_id DenoiseSession::deviceId() const { return m_implementation->m_device(); }
cl_command_queue DenoiseSession::queue() const { return m_implementation->m_queue(); }

void OutputHash::add(const io::Image& image) { m_hash = fnv1a(image.pixels.data(), bytesOf(image), m_hash); }

std::string OutputHash::text() const { return fmt::format("{:016x}", m_hash); }

}  // namespace quell::cli
