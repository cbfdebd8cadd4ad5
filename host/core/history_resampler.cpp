#include "host/core/history_resampler.hpp"

#include "host/core/round_up.hpp"
#include "kernels/resample_history_params.h"

namespace quell {
namespace {

/// Bits are copied, whatever they mean.
const char* wordOf(std::size_t bytes) {
  switch (bytes) {
    case 1:
      return "uchar";
    case 2:
      return "ushort";
    case 16:
      return "uint4";
    default:
      return "uint";
  }
}

}  // namespace

void HistoryResampler::build(const KernelBuilder& builder, const Plan& plan) {
  m_lanes = static_cast<std::size_t>(builder.configuration().device.lanes);
  for (const BufferSpec& spec : plan.buffers) {
    const std::size_t bytes = elementBytes(spec.element);
    if (!spec.history || spec.extent.planes == 0 || m_copiers.count(bytes) != 0) continue;
    Copier& copier = m_copiers[bytes];
    copier.kernel = builder.build(kStem, std::string(" -D ELEMENT=") + wordOf(bytes));
    copier.workGroup = builder.pixelWorkGroup(copier.kernel);
  }
}

void HistoryResampler::enqueue(FrameCommands& commands, const Plan& plan, const BufferSet& buffers, int from,
                               Size oldSize, Size newSize) {
  const auto width = static_cast<std::size_t>(newSize.width),
             height = static_cast<std::size_t>(newSize.height);
  for (std::size_t i = 0; i < plan.buffers.size(); ++i) {
    const BufferSpec& spec = plan.buffers[i];
    if (!spec.history) continue;
    const cl::Buffer& source = buffers.current(static_cast<int>(i), from);
    const cl::Buffer& target = buffers.previous(static_cast<int>(i), from);
    if (spec.extent.planes == 0) {
      commands.fillWithZeros(target, elementCount(spec, newSize) * elementBytes(spec.element));
      continue;
    }
    Copier& copier = m_copiers.at(elementBytes(spec.element));
    const ResampleHistoryParams params{makePlanes(oldSize), makePlanes(newSize), spec.extent.planes};
    copier.kernel.setArg(0, source);
    copier.kernel.setArg(1, target);
    copier.kernel.setArg(2, sizeof(params), &params);
    const cl::NDRange& group = copier.workGroup;
    commands.enqueueAhead(
        copier.kernel,
        cl::NDRange(roundUp((width + m_lanes - 1) / m_lanes, group[0]), roundUp(height, group[1])), group);
  }
}

}  // namespace quell
