// Histories at another size, on the device and without waiting; host/core/history_transfer.hpp does it between pipelines.
#pragma once

#include <cstddef>
#include <map>

#include "host/core/buffer_set.hpp"
#include "host/core/frame_commands.hpp"
#include "host/core/stage.hpp"

namespace quell {

class HistoryResampler {
 public:
  static constexpr char kStem[] = "resample_history";

  /// Compiles what the histories of the plan take.
  void build(const KernelBuilder& builder, const Plan& plan);

  /// Enqueues, for all histories of that plan: what frames of parity `from` have left, at `oldSize`, into the other copy, at
  /// `newSize`. Buffers that are no planes become zero.
  void enqueue(FrameCommands& commands, const Plan& plan, const BufferSet& buffers, int from, Size oldSize,
               Size newSize);

 private:
  struct Copier {
    cl::Kernel kernel;
    cl::NDRange workGroup;
  };
  std::map<std::size_t, Copier> m_copiers;  // by the bytes of an element
  std::size_t m_lanes = 1;
};

}  // namespace quell
