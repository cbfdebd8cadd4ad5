#include "tests/support/stage_harness.hpp"

#include <chrono>
#include <cstdlib>
#include <quell/devices.hpp>
#include <stdexcept>

#include "host/core/buffer_reader.hpp"
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

double deviceMs(const std::vector<cl::Event>& events) {
  double sum = 0.0;
  for (const cl::Event& event : events) {
    const auto start = event.getProfilingInfo<CL_PROFILING_COMMAND_START>();
    const auto end = event.getProfilingInfo<CL_PROFILING_COMMAND_END>();
    sum += double(end - start) / kNanosecondsPerMs;
  }
  return sum;
}

// The buffer behind a port.
BufferSpec specOf(const Port& port) { return {port.name, port.element, port.extent}; }

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

}  // namespace

const TestDevice& TestDevice::shared() {
  static const TestDevice device = openDevice();
  return device;
}

StageHarness::StageHarness(const std::string& stem, const StageSetup& setup)
    : m_configuration{{}, {}, setup.settings, setup.frame, setup.output}, m_output(setup.output) {
  const TestDevice& device = TestDevice::shared();
  m_configuration.settings.set("skip", setup.skip ? "on" : "off");
  m_configuration.frame.size = setup.size;
  m_configuration.options.mapping = setup.mapping;
  m_configuration.options.workGroup = setup.workGroup;
  m_configuration.options.fitGroup = setup.fitGroup;
  m_configuration.device = queryDeviceTraits(device.device, setup.mapping);
  m_frame = m_configuration.frame;

  const Method& method = findMethod(m_configuration.settings.method());
  m_configuration.runtime = method.runtimeSettings(m_configuration.settings);
  requireFBetaImages(m_configuration);
  if (dividesByFBeta(m_configuration))
    m_configuration.tables["fBetaTable"] = sharedFBetaTexels(Mapping::Wide, Shadowing::Separable).buffer();
  Schedule schedule = method.makeSchedule(m_configuration);
  makePlan(schedule, m_configuration);  // the method as a whole must fit together as well
  int skip = setup.occurrence;
  for (StageRow& row : schedule)
    if (row.stage->name() == stem && skip-- == 0) m_stage = std::move(row.stage);
  if (!m_stage) throw std::logic_error("this setup's schedule has no stage " + stem);
  ProgramShelf shelf;
  m_stage->build(DeviceKernelBuilder(device.context, device.device, device.cache, m_configuration, shelf));
  m_ports = m_stage->ports(m_configuration);
  allocate();
}

void StageHarness::allocate() {
  const TestDevice& device = TestDevice::shared();
  for (const Port& port : m_ports) {
    if (!port.exists || port.isImage()) continue;
    if (port.access == Access::Table) {
      m_buffers[port.name] = m_configuration.tables.at(port.name);
      continue;
    }
    const std::size_t bytes = elementCount(specOf(port), size()) * elementBytes(port.element);
    const cl::Buffer buffer(device.context, CL_MEM_READ_WRITE, bytes);
    if (port.element == Element::UInt8) {
      device.queue.enqueueFillBuffer(buffer, kByteRubbish, 0, bytes);
    } else if (port.element == Element::Int32) {
      device.queue.enqueueFillBuffer(buffer, kWordRubbish, 0, bytes);
    } else if (port.element == Element::Float32) {
      device.queue.enqueueFillBuffer(buffer, kRubbish, 0, bytes);
    }
    m_buffers[port.name] = buffer;
  }
  for (const auto& image : kOutputs<Output>)
    if ((m_output.*image.member).present()) clearOutput(image.member);
}

const Port& StageHarness::port(const std::string& name) const {
  for (const Port& port : m_ports)
    if (port.exists && !port.isImage() && name == port.name) return port;
  throw std::logic_error("the stage " + m_stage->name() + " has no port " + name);
}

bool StageHarness::hasPort(const std::string& name) const { return m_buffers.count(name) != 0; }

void StageHarness::upload(const std::string& name, const Planes& planes) {
  const BufferSpec spec = specOf(port(name));
  if (spec.element == Element::Float32) {
    uploadAs<float>(m_buffers.at(name), spec, size(), planes, kRubbish);
  } else if (spec.element == Element::Int32) {
    uploadAs<cl_uint>(m_buffers.at(name), spec, size(), planes, kWordRubbish);
  } else {
    uploadAs<cl_uchar>(m_buffers.at(name), spec, size(), planes, kByteRubbish);
  }
}

Planes StageHarness::download(const std::string& name) const {
  const BufferContent content =
      readBufferContent(TestDevice::shared().queue, m_buffers.at(name), specOf(port(name)), size());
  Planes planes({content.width, content.height}, content.planes);
  planes.values = content.values;
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

std::vector<unsigned char> StageHarness::outputBytes(const ImageView Output::*image) const {
  std::vector<unsigned char> bytes((m_output.*image).requiredBytes(size()));
  TestDevice::shared().queue.enqueueReadBuffer(m_images.at(imageName(image)), CL_TRUE, 0, bytes.size(),
                                               bytes.data());
  return bytes;
}

io::Image StageHarness::output(const ImageView Output::*image) const {
  return decodeImage(outputBytes(image), m_output.*image, size());
}

double StageHarness::run(const ReprojectionParams& reprojection, std::uint32_t frameIndex) {
  std::vector<Argument> arguments;
  for (const Port& port : m_ports) {
    if (!port.isArgument()) continue;
    const cl_mem memory = port.isImage() ? port.view(m_frame, m_output).memory
                          : port.exists  ? m_buffers.at(port.name)()
                                         : nullptr;
    arguments.push_back({memory, false});
  }
  std::vector<cl::Event> events;
  const auto enqueue = [&](const cl::Kernel& kernel, const cl::NDRange& range, const cl::NDRange& local) {
    events.emplace_back();
    TestDevice::shared().queue.enqueueNDRangeKernel(kernel, cl::NullRange, range, local, nullptr,
                                                    &events.back());
  };
  const auto start = std::chrono::steady_clock::now();
  FrameRun run(m_configuration, m_frame, m_output, reprojection, frameIndex, std::move(arguments), enqueue);
  m_stage->enqueue(run);
  TestDevice::shared().queue.finish();
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  const double device = deviceMs(events);
  return device > 0.0 ? device : wall.count();
}

std::uint64_t StageHarness::bytesMoved(const Content& content) const {
  return stageBytes(*m_stage, m_configuration, content);
}

}  // namespace quell::tests
