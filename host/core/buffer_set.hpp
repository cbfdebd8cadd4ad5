// The device memory behind a method's buffers.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "host/core/bound_kernel.hpp"
#include "host/core/schedule.hpp"

namespace quell {

/// Transient buffers whose lifetimes do not overlap share memory.
class BufferSet {
 public:
  BufferSet() = default;
  /// Knows how much memory there would be, and allocates none.
  BufferSet(const Plan& plan, Size size, const std::vector<std::string>& kept);
  /// Allocates and fills with zeros (blocks); buffers in `kept` keep their memory to the end of the frame. Throws
  /// Error(OutOfMemory) naming the buffer.
  BufferSet(const cl::Context& context, const cl::CommandQueue& queue, const Plan& plan, Size size,
            const std::vector<std::string>& kept = {});

  /// A buffer of the plan in a frame of this parity: what is written now, or what the frame before has left.
  const cl::Buffer& current(int buffer, int parity) const;
  const cl::Buffer& previous(int buffer, int parity) const;

  /// What the ports of a row of the plan are bound to in a frame of this parity, in their order; null where there is
  /// no buffer, and nothing for an input that is absent.
  std::vector<Argument> arguments(const std::vector<Binding>& row, const Configuration& configuration,
                                  const Frame& frame, const Output& output, int parity) const;

  /// A buffer that is kept from frame to frame, as the frames of either parity write it.
  struct History {
    std::string name;
    std::size_t bytes = 0;
    std::array<cl::Buffer, 2> copies;
  };
  std::vector<History> histories() const;

  MemoryUse memoryUse() const;

  /// Makes what frames of either parity have left of the histories that of the others.
  void swapHistories();

 private:
  struct Slot {
    std::string names;
    std::size_t bytes = 0;
    std::array<cl::Buffer, 2> buffers;  // the second for history only
    bool history = false;
    int busyUntil = -1;  // row after which the memory is free again
  };
  const Slot& slot(int buffer) const;

  std::vector<Slot> m_slots;
  std::vector<std::size_t> m_slotOf;  // per buffer of the plan
};

}  // namespace quell
