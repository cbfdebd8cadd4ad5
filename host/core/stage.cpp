#include "host/core/stage.hpp"

#include <algorithm>
#include <stdexcept>

#include "host/core/kernel_sources.hpp"

namespace quell {
namespace {

// Work-group of per-pixel kernels where nothing else is asked for: a row of 64 lanes keeps loads coalesced on
// GPUs. On CPUs the shape hardly matters; small groups leave enough of them to balance cores.
constexpr std::size_t kGpuWorkGroup[2] = {64, 4};
constexpr std::size_t kCpuWorkGroup[2] = {8, 1};

}  // namespace

cl::Kernel KernelBuilder::build(const std::string& stem, const std::string& options) const {
  return compile(
      stem, "-cl-std=CL1.2 -D QUELL_LANES=" + std::to_string(m_configuration.device.lanes) + " " + options);
}

cl::Kernel DeviceKernelBuilder::compile(const std::string& stem, const std::string& options) const {
  const auto found = kernelSources().find(stem);
  if (found == kernelSources().end()) throw std::logic_error("no kernel source " + stem);
  const cl::Program program =
      m_cache.build(m_context, m_device, configuration().device, stem, found->second, options);
  return cl::Kernel(program, stem.c_str());
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
  const auto& usual = m_configuration.device.isCpu ? kCpuWorkGroup : kGpuWorkGroup;
  std::size_t x = wish[0] > 0 ? static_cast<std::size_t>(wish[0]) : usual[0];
  std::size_t y = wish[1] > 0 ? static_cast<std::size_t>(wish[1]) : usual[1];
  const std::size_t most = std::max<std::size_t>(1, maxWorkGroup(kernel));
  while (x * y > most && y > 1) y /= 2;
  while (x * y > most) x /= 2;
  return cl::NDRange(x, y);
}

std::string layoutOptions(const std::string& name, const ImageView& view) {
  // As QUELL_FORMAT_FLOAT and its like in kernels/common/image_access.h.
  const int format = !view.present() ? 0 : static_cast<int>(view.format) + 1;
  const std::size_t stride = view.present() ? view.pixelStride() / view.componentBytes() : 0;
  return " -D " + name + "_FORMAT=" + std::to_string(format) + " -D " + name +
         "_CHANNELS=" + std::to_string(view.channels) + " -D " + name + "_STRIDE=" + std::to_string(stride);
}

ImageViewParams makeViewParams(const ImageView& view, Size size) {
  ImageViewParams params{};
  if (!view.present()) return params;
  params.offset = static_cast<QuellInt>(view.offsetBytes / view.componentBytes());
  params.rowPitch = static_cast<QuellInt>(view.rowPitch(size.width) / view.componentBytes());
  return params;
}

std::uint64_t imageBytes(const ImageView& view, Size size) {
  return static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
         static_cast<std::uint64_t>(view.channels) * view.componentBytes();
}

std::array<std::size_t, 2> FrameRun::pixelRange() const { return pixelItems(configuration); }

}  // namespace quell
