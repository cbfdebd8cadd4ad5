#include "host/core/buffer_set.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "host/core/cl_error.hpp"

namespace quell {
namespace {

cl::Buffer allocate(const cl::Context& context, std::size_t bytes, const std::string& names) {
  try {
    return cl::Buffer(context, CL_MEM_READ_WRITE, bytes);
  } catch (const cl::Error& error) {
    throw translateClError(error.err(), std::string(error.what()) + " of " + std::to_string(bytes) + " bytes",
                           "prepare", names);
  }
}

}  // namespace

BufferSet::BufferSet(const Plan& plan, Size size, const std::vector<std::string>& kept) {
  for (const BufferSpec& spec : plan.buffers) {
    const std::size_t bytes = elementCount(spec, size) * elementBytes(spec.element);
    const bool isKept = std::find(kept.begin(), kept.end(), spec.name) != kept.end();
    const auto free = std::find_if(m_slots.begin(), m_slots.end(), [&](const Slot& slot) {
      return !spec.history && !slot.history && slot.busyUntil < spec.firstRow && slot.bytes >= bytes;
    });
    m_slotOf.push_back(static_cast<std::size_t>(free - m_slots.begin()));
    if (free == m_slots.end()) m_slots.push_back({"", bytes, {}, spec.history, -1});
    Slot& slot = m_slots[m_slotOf.back()];
    slot.names += (slot.names.empty() ? "" : " + ") + spec.name;
    slot.busyUntil = isKept ? std::numeric_limits<int>::max() : spec.lastRow;
  }
}

BufferSet::BufferSet(const cl::Context& context, const cl::CommandQueue& queue, const Plan& plan, Size size,
                     const std::vector<std::string>& kept)
    : BufferSet(plan, size, kept) {
  for (Slot& slot : m_slots) {
    for (std::size_t copy = 0; copy < (slot.history ? 2u : 1u); ++copy) {
      slot.buffers[copy] = allocate(context, slot.bytes, slot.names);
      // Margins must hold finite numbers: they are loaded along with their neighbours and then masked out.
      queue.enqueueFillBuffer(slot.buffers[copy], cl_uchar(0), 0, slot.bytes);
    }
  }
  queue.finish();
}

const BufferSet::Slot& BufferSet::slot(int buffer) const {
  return m_slots.at(m_slotOf.at(static_cast<std::size_t>(buffer)));
}

const cl::Buffer& BufferSet::current(int buffer, int parity) const {
  const Slot& memory = slot(buffer);
  return memory.buffers[memory.history ? static_cast<std::size_t>(parity) : 0];
}

const cl::Buffer& BufferSet::previous(int buffer, int parity) const { return current(buffer, 1 - parity); }

std::vector<Argument> BufferSet::arguments(const std::vector<Binding>& row,
                                           const Configuration& configuration, const Frame& frame,
                                           const Output& output, int parity) const {
  std::vector<Argument> arguments;
  arguments.reserve(row.size());
  for (const Binding& binding : row) {
    const Port& port = binding.port;
    if (!port.isArgument()) continue;
    if (!port.exists) {
      arguments.push_back({nullptr, true});
    } else if (port.isImage() && !binding.hasBuffer()) {
      arguments.push_back({port.view(frame, output).memory, false});
    } else if (port.access == Access::Table) {
      arguments.push_back({configuration.tables.at(port.name)(), true});
    } else {
      const cl::Buffer& buffer = port.access == Access::Previous ? previous(binding.buffer, parity)
                                                                 : current(binding.buffer, parity);
      arguments.push_back({buffer(), true});
    }
  }
  return arguments;
}

std::vector<BufferSet::History> BufferSet::histories() const {
  std::vector<History> all;
  for (const Slot& slot : m_slots)
    if (slot.history) all.push_back({slot.names, slot.bytes, slot.buffers});
  return all;
}

void BufferSet::swapHistories() {
  for (Slot& slot : m_slots)
    if (slot.history) std::swap(slot.buffers[0], slot.buffers[1]);
}

MemoryUse BufferSet::memoryUse() const {
  MemoryUse use;
  for (const Slot& slot : m_slots) {
    const std::size_t bytes = slot.bytes * (slot.history ? 2 : 1);
    use.buffers.push_back({slot.names, bytes});
    use.totalBytes += bytes;
  }
  return use;
}

}  // namespace quell
