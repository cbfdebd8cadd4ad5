// The checks of a sequence, frame by frame.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host/check/context.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// What was found in one or more frames; as in the first of them, but the worst of their severities.
struct SequenceFinding {
  Finding finding;
  std::string file;         ///< of the first frame
  std::vector<int> frames;  ///< that show it, ascending
};

struct SequenceFigure {
  CheckFigure figure;  ///< the mean over the frames
  double least, most;
  int frames;
};

struct SequenceCheck {
  std::vector<int> frames;  ///< that were looked at
  std::vector<SequenceFigure> figures;
  std::vector<SequenceFinding> findings;  ///< the worst first, else in order of the frames

  Severity worst() const;  ///< Note where there is nothing
};

/// Called for each finding of each frame, for pictures.
using FindingSink = std::function<void(const io::FrameData& frame, const check::MappedFinding& found)>;

/// Checks frames and the references that there are among them. Throws what FrameSequence::read() throws.
SequenceCheck checkSequence(const io::FrameSequence& sequence, const std::vector<int>& frames,
                            const FindingSink& sink = {});

}  // namespace quell::cli
