#include "host/core/schedule.hpp"

#include <algorithm>
#include <stdexcept>

#include "host/core/cl_error.hpp"
#include "host/core/stage.hpp"

namespace quell {
namespace {

constexpr char kPreviousSuffix[] = ".prev";

int roundUp(int value, int multiple) { return (value + multiple - 1) / multiple * multiple; }

bool endsWithPrevious(const std::string& name) {
  const std::size_t length = sizeof(kPreviousSuffix) - 1;
  return name.size() > length && name.compare(name.size() - length, length, kPreviousSuffix) == 0;
}

// First and last line of the table that touches a buffer.
struct Lifetime {
  int first = -1;
  int last = -1;
};

Lifetime lifetimeOf(const std::string& name, const std::vector<StageRow>& stages) {
  Lifetime lifetime;
  for (int row = 0; row < static_cast<int>(stages.size()); ++row) {
    if (!contains(stages[row].reads, name) && !contains(stages[row].writes, name)) continue;
    if (lifetime.first < 0) lifetime.first = row;
    lifetime.last = row;
  }
  return lifetime;
}

// The buffers that a stage uses, first used first: then most of them find memory that is free again.
std::vector<BufferSpec> inOrderOfUse(const Schedule& schedule) {
  std::vector<BufferSpec> used;
  for (const BufferSpec& spec : schedule.buffers)
    if (spec.history || lifetimeOf(spec.name, schedule.stages).first >= 0) used.push_back(spec);
  std::stable_sort(used.begin(), used.end(), [&](const BufferSpec& a, const BufferSpec& b) {
    return lifetimeOf(a.name, schedule.stages).first < lifetimeOf(b.name, schedule.stages).first;
  });
  return used;
}

std::string joinedNames(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " + ") + name;
  return text;
}

cl::Buffer allocate(const cl::Context& context, std::size_t bytes, const std::string& names) {
  try {
    return cl::Buffer(context, CL_MEM_READ_WRITE, bytes);
  } catch (const cl::Error& error) {
    throw translateClError(error.err(), std::string(error.what()) + " of " + std::to_string(bytes) + " bytes",
                           "prepare", names);
  }
}

}  // namespace

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::array<std::size_t, 2> pixelItems(const Configuration& configuration) {
  const std::size_t lanes = static_cast<std::size_t>(configuration.device.lanes);
  const std::size_t width = static_cast<std::size_t>(configuration.size().width);
  return {(width + lanes - 1) / lanes, static_cast<std::size_t>(configuration.size().height)};
}

PlaneParams makePlanes(Size size) {
  PlaneParams planes;
  planes.width = size.width;
  planes.height = size.height;
  planes.pitch = roundUp(size.width, QUELL_PLANE_MARGIN) + 2 * QUELL_PLANE_MARGIN;
  planes.stride = planes.pitch * (size.height + 2 * QUELL_PLANE_MARGIN_ROWS);
  return planes;
}

std::size_t elementBytes(Element element) { return element == Element::UInt8 ? 1 : 4; }

std::size_t elementCount(const BufferSpec& spec, Size size) {
  if (spec.planes == 0) return spec.elements;
  return static_cast<std::size_t>(makePlanes(size).stride) * static_cast<std::size_t>(spec.planes);
}

std::uint64_t payloadBytes(const BufferSpec& spec, Size size) {
  const std::uint64_t elements = spec.planes == 0 ? spec.elements
                                                  : static_cast<std::uint64_t>(size.width) *
                                                        static_cast<std::uint64_t>(size.height) *
                                                        static_cast<std::uint64_t>(spec.planes);
  return elements * elementBytes(spec.element);
}

BufferSet::BufferSet(const cl::Context& context, const cl::CommandQueue& queue, const Schedule& schedule,
                     Size size) {
  // Line of the table after which the memory of each slot is free again.
  std::vector<int> busyUntil;
  for (const BufferSpec& spec : inOrderOfUse(schedule)) {
    const Lifetime lifetime = lifetimeOf(spec.name, schedule.stages);
    const std::size_t bytes = elementCount(spec, size) * elementBytes(spec.element);
    std::size_t slot = m_slots.size();
    for (std::size_t i = 0; i < m_slots.size() && !spec.history && slot == m_slots.size(); ++i)
      if (!m_slots[i].history && busyUntil[i] < lifetime.first && m_slots[i].bytes >= bytes) slot = i;
    if (slot == m_slots.size()) {
      m_slots.push_back({{}, bytes, {}, spec.history});
      busyUntil.push_back(-1);
    }
    m_slots[slot].names.push_back(spec.name);
    busyUntil[slot] = lifetime.last;
  }
  for (Slot& slot : m_slots) {
    for (int copy = 0; copy < (slot.history ? 2 : 1); ++copy) {
      slot.buffers[copy] = allocate(context, slot.bytes, joinedNames(slot.names));
      // Margins must hold finite numbers: they are loaded along with their neighbours and then masked out.
      queue.enqueueFillBuffer(slot.buffers[copy], cl_uchar(0), 0, slot.bytes);
    }
  }
  queue.finish();
}

const BufferSet::Slot& BufferSet::slotOf(const std::string& name) const {
  for (const Slot& slot : m_slots)
    if (contains(slot.names, name)) return slot;
  throw std::logic_error("the method's table has no buffer " + name);
}

const cl::Buffer& BufferSet::get(const std::string& name, int parity) const {
  if (endsWithPrevious(name)) {
    const Slot& slot = slotOf(name.substr(0, name.size() - (sizeof(kPreviousSuffix) - 1)));
    if (!slot.history) throw std::logic_error("the method's table keeps no history of " + name);
    return slot.buffers[1 - parity];
  }
  const Slot& slot = slotOf(name);
  return slot.buffers[slot.history ? parity : 0];
}

MemoryUse BufferSet::memoryUse() const {
  MemoryUse use;
  for (const Slot& slot : m_slots) {
    const std::size_t bytes = slot.bytes * (slot.history ? 2 : 1);
    use.buffers.push_back({joinedNames(slot.names), bytes});
    use.totalBytes += bytes;
  }
  return use;
}

}  // namespace quell
