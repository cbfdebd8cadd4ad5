// Whole frames with the faults that renderers produce, for the methods as they are used: with history, frame by frame.
#pragma once

#include <string>
#include <vector>

#include "host/io/frame_sequence.hpp"
#include "host/stress/random.hpp"

namespace quell::stress {

/// Pixels of a frame; faults are kept to the first kFaultEdge columns and rows.
constexpr int kFrameWidth = 192, kFrameHeight = 128, kFaultEdge = 24;
/// Frames of a run: clean ones, so that there is a history, then with the fault, then clean again.
constexpr int kFramesBefore = 3, kFramesWithFault = 2, kFramesAfter = 20;
constexpr int kFramesInAll = kFramesBefore + kFramesWithFault + kFramesAfter;

enum class Trace {
  Gone,    ///< the faults are no samples, or ones like others: the picture must return to the clean one
  Fading,  ///< the faults are extreme samples: a mean over time keeps their share, but it must shrink
};

struct FrameFamily {
  std::string name;
  Trace trace;
  bool wholeFrame;  ///< the fault is everywhere
  bool halfInputs;  ///< images are stored as halves
  void (*makeFault)(io::FrameData& frame, Random& random);
};

/// All families in the order of the table.
const std::vector<FrameFamily>& frameFamilies();

/// The frames of a family's run, without its faults and with them. Equal arguments give equal frames.
struct FrameRuns {
  std::vector<io::FrameData> clean, faulty;
};
FrameRuns makeFrameRuns(const FrameFamily& family, std::uint32_t seed);

}  // namespace quell::stress
