#include "host/core/stage.hpp"

#include <algorithm>
#include <quell/error.hpp>

#include "host/core/imported_images.hpp"
#include "host/core/round_up.hpp"

namespace quell {
namespace {

// Work-group of per-pixel kernels where nothing else is asked for: a row of 64 lanes keeps loads coalesced on
// GPUs. On CPUs the shape hardly matters; small groups leave enough of them to balance cores. One work-item that has a
// vector of pixels makes a group of its own: without a loop around it kernels compile in 7/10 of the time.
constexpr std::size_t kGpuWorkGroup[2] = {64, 4};
constexpr std::size_t kCpuWorkGroup[2] = {8, 1};
constexpr std::size_t kCpuWideWorkGroup[2] = {1, 1};

// Compile options that describe the layout of a caller's image: NAME_FORMAT, NAME_CHANNELS, NAME_STRIDE.
std::string layoutOptions(const Port& port, const ImageView& view) {
  const std::string name = port.options;
  // As QUELL_FORMAT_FLOAT and its like in kernels/common/image_access.h.
  const int format = !view.present() ? 0 : static_cast<int>(view.format) + 1;
  const std::size_t stride =
      view.present() && !view.isImageObject() ? view.pixelStride() / view.componentBytes() : 0;
  return " -D " + name + "_FORMAT=" + std::to_string(format) + " -D " + name +
         "_CHANNELS=" + std::to_string(view.channels) + " -D " + name + "_STRIDE=" + std::to_string(stride);
}

}  // namespace

cl::Kernel KernelBuilder::build(const Stage& stage, const std::string& defines) const {
  std::string options = defines;
  for (const Port& port : stage.ports(m_configuration))
    if (port.isImage())
      options += layoutOptions(port, port.view(m_configuration.frame, m_configuration.output));
  return build(stage.name(), options);
}

cl::Kernel KernelBuilder::build(const std::string& stem, const std::string& defines) const {
  return compile(
      {stem, "-cl-std=CL1.2 -D QUELL_LANES=" + std::to_string(m_configuration.device.lanes) + defines});
}

cl::Kernel DeviceKernelBuilder::compile(const KernelUse& use) const {
  if (!m_shelf.find(use)) buildGroup(m_shelf.groupOf(use));
  return cl::Kernel(*m_shelf.find(use), use.stem.c_str());
}

SharedProgram DeviceKernelBuilder::share(const ProgramGroup& group) const {
  return m_cache.share(m_context, m_device, configuration().device, group.name(), group.source(),
                       group.options());
}

void DeviceKernelBuilder::buildGroup(const ProgramGroup& group) const {
  try {
    m_shelf.put(group, share(group));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::BuildFailed || group.kernels.size() == 1) throw;
    // One by one the compiler names the kernel that it refuses, or takes what it cannot take together.
    for (const KernelUse& use : group.kernels) m_shelf.put({{use}}, share({{use}}));
  }
}

std::size_t DeviceKernelBuilder::maxWorkGroup(const cl::Kernel& kernel) const {
  return std::min(configuration().device.maxWorkGroup,
                  kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(m_device));
}

std::size_t KernelBuilder::groupSize(int wish, std::size_t usual) const {
  std::size_t size = wish > 0 ? static_cast<std::size_t>(wish) : usual;
  while (size > 1 && size > m_configuration.device.maxWorkGroup) size /= 2;
  return size;
}

cl::NDRange KernelBuilder::pixelWorkGroup(const cl::Kernel& kernel) const {
  const auto& wish = m_configuration.options.workGroup;
  const auto& usual = !m_configuration.device.isCpu                 ? kGpuWorkGroup
                      : m_configuration.device.lanes > kNarrowLanes ? kCpuWideWorkGroup
                                                                    : kCpuWorkGroup;
  std::size_t x = wish[0] > 0 ? static_cast<std::size_t>(wish[0]) : usual[0];
  std::size_t y = wish[1] > 0 ? static_cast<std::size_t>(wish[1]) : usual[1];
  const std::size_t most = std::max<std::size_t>(1, maxWorkGroup(kernel));
  while (x * y > most && y > 1) y /= 2;
  while (x * y > most) x /= 2;
  return cl::NDRange(x, y);
}

ImageViewParams makeViewParams(const ImageView& view, Size size) {
  ImageViewParams params{};
  if (!view.present()) return params;
  if (view.isImageObject()) {
    const bool bottomUp = view.rowPitchBytes < 0;
    params.offset = bottomUp ? size.height - 1 : 0;
    params.rowPitch = bottomUp ? -1 : 1;
    return params;
  }
  const auto component = static_cast<std::ptrdiff_t>(view.componentBytes());
  params.offset = static_cast<QuellInt>(view.offsetBytes / view.componentBytes());
  params.rowPitch = static_cast<QuellInt>(view.rowPitch(size.width) / component);
  return params;
}

FrameImageParams makeImageParams(const Frame& frame) {
  FrameImageParams params{};
#define QUELL_VIEW_PARAMS(name, NAME, least, most, kind, presence, files, texts) \
  params.name = makeViewParams(viewForStages(frame, &Frame::name), frame.size);
  QUELL_FRAME_IMAGES(QUELL_VIEW_PARAMS)
#undef QUELL_VIEW_PARAMS
  return params;
}

OutputImageParams makeImageParams(const Output& output, Size size) {
  OutputImageParams params{};
#define QUELL_VIEW_PARAMS(name, NAME, least, most, kind, presence, files, texts) \
  params.name = makeViewParams(output.name, size);
  QUELL_OUTPUT_IMAGES(QUELL_VIEW_PARAMS)
#undef QUELL_VIEW_PARAMS
  return params;
}

void FrameRun::enqueueRounded(const cl::Kernel& kernel, std::array<std::size_t, 2> global,
                              const cl::NDRange& local) const {
  m_enqueue(kernel, cl::NDRange(roundUp(global[0], local[0]), roundUp(global[1], local[1])), local);
}

Coverage coverageOf(const Stage& stage, const Configuration& configuration) {
  for (const Port& port : stage.ports(configuration))
    if (port.exists && port.access == Access::Read && port.usualBuffer() == kSurfacesBuffer)
      return stage.coverage(configuration.frame);
  return Coverage::Everything;
}

bool leavesOutBackground(Coverage coverage) {
  return coverage == Coverage::Surfaces || coverage == Coverage::AroundSurfaces;
}

double coveredShare(Coverage coverage, const Content& content) {
  switch (coverage) {
    case Coverage::Everything:
      return 1.0;
    case Coverage::Surfaces:
      return content.surfaces;
    case Coverage::AroundSurfaces:
      return content.surfaces + (1.0 - content.surfaces) * content.nearSurfaces;
    case Coverage::Background:
      return 1.0 - content.surfaces;
  }
  return 1.0;
}

std::uint64_t stageBytes(const Stage& stage, const Configuration& configuration, const Content& content) {
  const Coverage coverage = coverageOf(stage, configuration);
  const double share = coveredShare(coverage, content);
  double bytes = 0.0;
  for (const Port& port : stage.ports(configuration, content)) {
    const bool perPixel = port.isImage() || port.extent.planes > 0;
    bytes += touchedBytes(port, configuration) * (perPixel ? share : 1.0);
  }
  return static_cast<std::uint64_t>(bytes + 0.5);
}

}  // namespace quell
