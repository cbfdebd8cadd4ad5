#include "host/stress/frame_suite.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <quell/devices.hpp>
#include <utility>

#include "host/core/cl_error.hpp"
#include "host/core/opencl.hpp"
#include "kernels/common/types.h"

namespace quell::stress {
namespace {

constexpr int kOutputChannels = 3;
constexpr std::size_t kPixels = std::size_t{kFrameWidth} * std::size_t{kFrameHeight};

struct Picture {
  std::vector<float> linear, display;
};

bool within(const std::vector<float>& values, float most) {
  return std::all_of(values.begin(), values.end(), [most](float v) { return v >= 0.0f && v <= most; });
}

// Largest distance of a pixel away from the fault from the range of its channel in the clean noisy frame, per range.
double outsideRange(const std::vector<float>& linear, const io::Image& noisy) {
  double largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    float low = noisy.at(0, 0, c), high = low;
    for (int y = 0; y < kFrameHeight; ++y)
      for (int x = 0; x < kFrameWidth; ++x) {
        low = std::min(low, noisy.at(x, y, c));
        high = std::max(high, noisy.at(x, y, c));
      }
    for (int y = 0; y < kFrameHeight; ++y)
      for (int x = 0; x < kFrameWidth; ++x) {
        if (x < kFaultEdge + kFaultReach && y < kFaultEdge + kFaultReach) continue;
        const float value =
            linear[3 * static_cast<std::size_t>(y * kFrameWidth + x) + static_cast<std::size_t>(c)];
        largest = std::max<double>(largest, std::max(low - value, value - high) / (high - low));
      }
  }
  return largest;
}

// Mean absolute difference per mean of the clean picture.
double meanDifference(const std::vector<float>& clean, const std::vector<float>& faulty) {
  double difference = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < clean.size(); ++i) {
    difference += std::abs(double{clean[i]} - double{faulty[i]});
    sum += double{clean[i]};
  }
  return difference / sum;
}

}  // namespace

/// A denoiser with buffers for frames with the images of an example, stored as floats or halves.
class FrameSuite::Runner {
 public:
  Runner(const std::string& device, const std::string& method, const Options& options, bool halfInputs,
         const io::FrameData& example)
      : m_device(chooseDevice(device).device, true),
        m_context(m_device),
        m_queue(m_context, m_device),
        m_denoiser(m_context(), m_device(), m_queue(), Settings(method), options),
        m_halfInputs(halfInputs) {
    m_frame.size = {kFrameWidth, kFrameHeight};
    const auto format = halfInputs ? ComponentFormat::Float16 : ComponentFormat::Float32;
    forEachInput(example, m_frame, [&](const ImageFacts&, const io::Image& image, ImageView& view) {
      if (!image.empty()) view = makeImage(image.channels, format);
    });
    m_output = {makeImage(kOutputChannels, ComponentFormat::Float32),
                makeImage(kOutputChannels, ComponentFormat::Float32)};
    m_denoiser.prepare(m_frame, m_output);
  }

  void resetHistory() { m_denoiser.resetHistory(); }

  Picture denoise(const io::FrameData& data) {
    m_frame.camera = data.camera;
    forEachInput(data, m_frame, [&](const ImageFacts&, const io::Image& image, const ImageView& view) {
      if (view.present()) upload(view, image.pixels);
    });
    m_denoiser.denoise(m_frame, m_output).wait();
    return {download(m_output.linear), download(m_output.display)};
  }

 private:
  ImageView makeImage(int channels, ComponentFormat format) {
    m_buffers.emplace_back(m_context, CL_MEM_READ_WRITE,
                           static_cast<std::size_t>(channels) * kPixels * sizeof(float));
    return packedImage(m_buffers.back()(), channels, format);
  }

  void upload(const ImageView& view, const std::vector<float>& values) {
    const cl::Buffer buffer(view.memory, true);
    if (m_halfInputs) {
      std::vector<Eigen::half> halves(values.size());
      std::transform(values.begin(), values.end(), halves.begin(), [](float v) { return Eigen::half(v); });
      m_queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, halves.size() * sizeof(Eigen::half), halves.data());
    } else {
      m_queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, values.size() * sizeof(float), values.data());
    }
  }

  std::vector<float> download(const ImageView& view) {
    std::vector<float> values(kOutputChannels * kPixels);
    m_queue.enqueueReadBuffer(cl::Buffer(view.memory, true), CL_TRUE, 0, values.size() * sizeof(float),
                              values.data());
    return values;
  }

  cl::Device m_device;
  cl::Context m_context;
  cl::CommandQueue m_queue;
  Denoiser m_denoiser;
  bool m_halfInputs;
  std::vector<cl::Buffer> m_buffers;
  Frame m_frame;
  Output m_output;
};

std::vector<std::string> frameMethods() { return methodNames(); }

FrameSuite::FrameSuite(std::string device, const Options& options)
    : m_device(std::move(device)), m_options(options) {}
FrameSuite::~FrameSuite() = default;

FrameSuite::Runner& FrameSuite::runner(const std::string& method, bool halfInputs, bool faulty,
                                       const io::FrameData& example) {
  auto& runner = m_runners[method + (halfInputs ? " half" : "") + (faulty ? " faulty" : "")];
  if (!runner) runner = std::make_unique<Runner>(m_device, method, m_options, halfInputs, example);
  runner->resetHistory();
  return *runner;
}

FrameFigures FrameSuite::run(const FrameFamily& family, const FrameRuns& runs, const std::string& method) {
  return withClErrors("stress", [&] {
    Runner& cleanRunner = runner(method, family.halfInputs, false, runs.clean.front());
    Runner& faultyRunner = runner(method, family.halfInputs, true, runs.clean.front());
    FrameFigures figures;
    for (std::size_t i = 0; i < runs.clean.size(); ++i) {
      const Picture clean = cleanRunner.denoise(runs.clean[i]);
      const Picture faulty = faultyRunner.denoise(runs.faulty[i]);
      const bool good = within(faulty.linear, QUELL_MAX_RADIANCE) && within(faulty.display, 1.0f);
      figures.nonFinite += good ? 0 : 1;
      const bool hasRange = !family.wholeFrame || i < kFramesBefore || i >= kFramesBefore + kFramesWithFault;
      if (hasRange)
        figures.outsideRange =
            std::max(figures.outsideRange, outsideRange(faulty.linear, runs.clean[i].radiance));
      figures.left = meanDifference(clean.linear, faulty.linear);
      figures.peak = std::max(figures.peak, figures.left);
    }
    return figures;
  });
}

bool withinBounds(const FrameFigures& figures, const FrameFamily& family) {
  if (figures.nonFinite > 0 || !(figures.outsideRange <= kMostOutsideFrameRange)) return false;
  return family.trace == Trace::Gone ? figures.left <= kMostLeftOfFault
                                     : figures.left <= kMostLeftOfPeak * figures.peak;
}

}  // namespace quell::stress
