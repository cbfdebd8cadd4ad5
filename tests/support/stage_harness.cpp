#include "tests/support/stage_harness.hpp"

#include <chrono>
#include <cstdlib>
#include <quell/devices.hpp>
#include <stdexcept>

#include "host/core/frame_images.hpp"
#include "host/core/image_schema.hpp"
#include "host/methods/method.hpp"
#include "tests/support/f_beta_texels.hpp"
#include "tests/support/image_layout.hpp"

namespace quell::tests {
namespace {

// What margins and unwritten pixels hold: finite, and unlike anything that a test expects.
constexpr float kRubbish = 777.0f;
constexpr cl_uchar kByteRubbish = 0xEE;
constexpr cl_uint kWordRubbish = 0xEEEEEE;
constexpr double kNanosecondsPerMs = 1e6;

class HarnessRun : public FrameRun {
 public:
  HarnessRun(const Configuration& c, const Frame& f, const Output& o, const ReprojectionParams& r,
             std::uint32_t index, const std::map<std::string, cl::Buffer>& buffers)
      : FrameRun(c, f, o, r, index), m_buffers(buffers) {}

  const cl::Buffer& buffer(const std::string& name) const override {
    const auto found = m_buffers.find(name);
    if (found == m_buffers.end())
      throw std::logic_error("the stage's line of the table does not name " + name);
    return found->second;
  }

  double deviceMs() const {
    double sum = 0.0;
    for (const cl::Event& event : m_events) {
      const auto start = event.getProfilingInfo<CL_PROFILING_COMMAND_START>();
      const auto end = event.getProfilingInfo<CL_PROFILING_COMMAND_END>();
      sum += double(end - start) / kNanosecondsPerMs;
    }
    return sum;
  }

 protected:
  void enqueue(const cl::Kernel& kernel, std::array<std::size_t, 2> global,
               const cl::NDRange& local) override {
    const auto padded = [](std::size_t items, std::size_t group) {
      return (items + group - 1) / group * group;
    };
    const cl::NDRange range(padded(global[0], local[0]), padded(global[1], local[1]));
    m_events.emplace_back();
    TestDevice::shared().queue.enqueueNDRangeKernel(kernel, cl::NullRange, range, local, nullptr,
                                                    &m_events.back());
  }

 private:
  const std::map<std::string, cl::Buffer>& m_buffers;
  std::vector<cl::Event> m_events;
};

TestDevice openDevice() {
  const char* spec = std::getenv("QUELL_TEST_DEVICE");
  const DeviceInfo info = chooseDevice(spec != nullptr ? spec : "");
  const cl::Device device(info.device, true);
  const cl::Context context(device);
  return {device, context, cl::CommandQueue(context, device, CL_QUEUE_PROFILING_ENABLE), ProgramCache("")};
}

std::string imageName(const ImageView Output::*image) {
  return image == &Output::linear ? "linear" : "display";
}

// Offset of pixel (x, y) of a plane among the elements of its buffer.
std::size_t elementOf(const PlaneParams& planes, int plane, int x, int y) {
  return std::size_t(plane) * std::size_t(planes.stride) +
         std::size_t(y + QUELL_PLANE_MARGIN_ROWS) * std::size_t(planes.pitch) + QUELL_PLANE_MARGIN +
         std::size_t(x);
}

// Calls work(element of the buffer, index into Planes::values) for everything that is not margin.
template <class Work>
void forEachElement(const BufferSpec& spec, Size size, Work&& work) {
  if (spec.planes == 0) {
    for (std::size_t i = 0; i < spec.elements; ++i) work(i, i);
    return;
  }
  const PlaneParams planes = makePlanes(size);
  std::size_t i = 0;
  for (int plane = 0; plane < spec.planes; ++plane)
    forEachPixel(size, [&](int x, int y) { work(elementOf(planes, plane, x, y), i++); });
}

template <class Value>
void uploadAs(const cl::Buffer& buffer, const BufferSpec& spec, Size size, const Planes& planes,
              Value rubbish) {
  std::vector<Value> elements(elementCount(spec, size), rubbish);
  forEachElement(spec, size, [&](std::size_t element, std::size_t i) {
    elements[element] = static_cast<Value>(planes.values.at(i));
  });
  TestDevice::shared().queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, elements.size() * sizeof(Value),
                                                elements.data());
}

template <class Value>
void downloadAs(const cl::Buffer& buffer, const BufferSpec& spec, Size size, Planes& planes) {
  std::vector<Value> elements(elementCount(spec, size));
  TestDevice::shared().queue.enqueueReadBuffer(buffer, CL_TRUE, 0, elements.size() * sizeof(Value),
                                               elements.data());
  forEachElement(spec, size,
                 [&](std::size_t element, std::size_t i) { planes.values[i] = float(elements[element]); });
}

}  // namespace

const TestDevice& TestDevice::shared() {
  static const TestDevice device = openDevice();
  return device;
}

StageHarness::StageHarness(const std::string& stem, const StageSetup& setup)
    : m_configuration{{}, {}, setup.settings, setup.frame, setup.output}, m_output(setup.output) {
  const TestDevice& device = TestDevice::shared();
  m_configuration.frame.size = setup.size;
  m_configuration.options.mapping = setup.mapping;
  m_configuration.options.workGroup = setup.workGroup;
  m_configuration.options.fitGroup = setup.fitGroup;
  m_configuration.device = queryDeviceTraits(device.device, setup.mapping);
  m_frame = m_configuration.frame;

  if (dividesByFBeta(m_configuration))
    m_configuration.fBetaTable = sharedFBetaTexels(Mapping::Wide, Shadowing::Separable).buffer();
  m_schedule = findMethod(setup.settings.method()).makeSchedule(m_configuration);
  int skip = setup.occurrence;
  const auto isWanted = [&](const StageRow& row) { return row.stage->name() == stem && skip-- == 0; };
  while (m_row < m_schedule.stages.size() && !isWanted(m_schedule.stages[m_row])) ++m_row;
  if (m_row == m_schedule.stages.size()) throw std::logic_error("this setup's schedule has no stage " + stem);
  m_schedule.stages[m_row].stage->build(
      DeviceKernelBuilder(device.context, device.device, device.cache, m_configuration));
  allocate();
}

void StageHarness::allocate() {
  const TestDevice& device = TestDevice::shared();
  const StageRow& row = m_schedule.stages[m_row];
  for (const auto* names : {&row.reads, &row.writes}) {
    for (const std::string& name : *names) {
      const BufferSpec& spec = specOf(name);
      const std::size_t bytes = elementCount(spec, size()) * elementBytes(spec.element);
      const cl::Buffer buffer(device.context, CL_MEM_READ_WRITE, bytes);
      if (spec.element == Element::Float32) {
        device.queue.enqueueFillBuffer(buffer, kRubbish, 0, bytes);
      } else if (spec.element == Element::UInt32) {
        device.queue.enqueueFillBuffer(buffer, kWordRubbish, 0, bytes);
      } else {
        device.queue.enqueueFillBuffer(buffer, kByteRubbish, 0, bytes);
      }
      m_buffers[name] = buffer;
    }
  }
  for (ImageView Output::*image : {&Output::linear, &Output::display})
    if ((m_output.*image).present()) clearOutput(image);
}

const BufferSpec& StageHarness::specOf(const std::string& name) const {
  for (const BufferSpec& spec : m_schedule.buffers)
    if (name == spec.name || (spec.history && name == spec.name + ".prev")) return spec;
  throw std::logic_error("the method's table has no buffer " + name);
}

void StageHarness::upload(const std::string& name, const Planes& planes) {
  const BufferSpec& spec = specOf(name);
  if (spec.element == Element::Float32) {
    uploadAs<float>(m_buffers.at(name), spec, size(), planes, kRubbish);
  } else if (spec.element == Element::UInt32) {
    uploadAs<cl_uint>(m_buffers.at(name), spec, size(), planes, kWordRubbish);
  } else {
    uploadAs<cl_uchar>(m_buffers.at(name), spec, size(), planes, kByteRubbish);
  }
}

Planes StageHarness::download(const std::string& name) const {
  const BufferSpec& spec = specOf(name);
  Planes planes =
      spec.planes > 0 ? Planes(size(), spec.planes) : Planes({static_cast<int>(spec.elements), 1}, 1);
  if (spec.element == Element::Float32) {
    downloadAs<float>(m_buffers.at(name), spec, size(), planes);
  } else if (spec.element == Element::UInt32) {
    downloadAs<cl_uint>(m_buffers.at(name), spec, size(), planes);
  } else {
    downloadAs<cl_uchar>(m_buffers.at(name), spec, size(), planes);
  }
  return planes;
}

void StageHarness::setInput(ImageView Frame::*image, const io::Image& pixels) {
  const TestDevice& device = TestDevice::shared();
  ImageView& view = m_frame.*image;
  std::vector<unsigned char> bytes = encodeImage(pixels, view, size());
  const cl::Buffer buffer(device.context, CL_MEM_READ_ONLY, bytes.size());
  device.queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes.size(), bytes.data());
  m_images[factsOf(image).name] = buffer;
  view.memory = buffer();
}

void StageHarness::clearOutput(ImageView Output::*image) {
  const TestDevice& device = TestDevice::shared();
  ImageView& view = m_output.*image;
  const io::Image blank(size().width, size().height, view.channels, kRubbish);
  const std::vector<unsigned char> bytes = encodeImage(blank, view, size());
  const cl::Buffer buffer(device.context, CL_MEM_READ_WRITE, bytes.size());
  device.queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes.size(), bytes.data());
  m_images[imageName(image)] = buffer;
  view.memory = buffer();
}

std::vector<unsigned char> StageHarness::outputBytes(ImageView Output::*image) const {
  std::vector<unsigned char> bytes((m_output.*image).requiredBytes(size()));
  TestDevice::shared().queue.enqueueReadBuffer(m_images.at(imageName(image)), CL_TRUE, 0, bytes.size(),
                                               bytes.data());
  return bytes;
}

io::Image StageHarness::output(ImageView Output::*image) const {
  return decodeImage(outputBytes(image), m_output.*image, size());
}

double StageHarness::run(const ReprojectionParams& reprojection, std::uint32_t frameIndex) {
  const auto start = std::chrono::steady_clock::now();
  HarnessRun run(m_configuration, m_frame, m_output, reprojection, frameIndex, m_buffers);
  m_schedule.stages[m_row].stage->enqueue(run);
  TestDevice::shared().queue.finish();
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  const double device = run.deviceMs();
  return device > 0.0 ? device : wall.count();
}

std::uint64_t StageHarness::bytesMoved() const {
  const StageRow& row = m_schedule.stages[m_row];
  std::uint64_t bytes = row.stage->callerBytes(m_configuration);
  for (const auto* names : {&row.reads, &row.writes})
    for (const std::string& name : *names) bytes += payloadBytes(specOf(name), size());
  return bytes;
}

}  // namespace quell::tests
