// Runs side by side, so that their times can be compared, and what goes with that.
#pragma once

#include <quell/quell.hpp>
#include <vector>

#include "host/cli/common/denoise_session.hpp"
#include "host/cli/common/run_plan.hpp"
#include "host/measure/copy_bandwidth.hpp"

namespace quell::cli {

/// Of the session's device. Throws quell::Error.
CopyBandwidth measureCopy(const DenoiseSession& session);

/// Calls work(run, frame) for every run, from the run at `first` on.
template <class Run, class Work>
void takeTurns(std::vector<Run>& runs, const io::FrameData& frame, std::size_t first, const Work& work) {
  for (std::size_t turn = 0; turn < runs.size(); ++turn) work(runs[(first + turn) % runs.size()], frame);
}

/// Calls work(run, frame) for every frame and run, all of which start without history. Drift of the machine hits all
/// runs alike: a frame goes through all of them before the next is read, and who comes first changes from frame to
/// frame and from `round` to round.
template <class Run, class Work>
void fairRound(std::vector<Run>& runs, const BenchInput& input, std::size_t round, const Work& work) {
  for (Run& run : runs) run.session->denoiser().resetHistory();
  for (std::size_t i = 0; i < input.frames.size(); ++i)
    takeTurns(runs, input.sequence->read(input.frames[i]), round + i, work);
}

}  // namespace quell::cli
