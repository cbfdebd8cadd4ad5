// Methods against the bounds of frame families: the figures that `quell stress` prints and the tests assert.
#pragma once

#include <map>
#include <memory>
#include <quell/denoiser.hpp>
#include <string>
#include <vector>

#include "host/stress/frame_families.hpp"

namespace quell::stress {

/// Away from the fault, pictures stay inside the range of the clean noisy frame widened by half its width at either
/// end. A fit of the default block size reaches two blocks far.
constexpr double kMostOutsideFrameRange = 0.5;
constexpr int kFaultReach = 72;  // pixels
/// Mean absolute difference from the clean run in the last frame, per mean of the clean picture.
constexpr double kMostLeftOfFault = 0.04;
/// The same per its largest value in any frame, where faults fade.
constexpr double kMostLeftOfPeak = 0.5;

/// Of one run of a method.
struct FrameFigures {
  int nonFinite = 0;          ///< frames with a value that is negative, NaN, Inf or out of the output's range
  double outsideRange = 0.0;  ///< largest distance from the range of the clean frame, per range
  double peak = 0.0;          ///< largest mean difference from the clean run, per mean of the clean picture
  double left = 0.0;          ///< the same of the last frame
};

/// The methods under test, by name: "svgf", ...; all with temporal antialiasing where they have it.
std::vector<std::string> frameMethods();

/// Denoisers of the runs, made when they are needed first.
class FrameSuite {
 public:
  /// `device` as for chooseDevice().
  FrameSuite(std::string device, const Options& options);
  ~FrameSuite();

  /// Starts from an empty history. Throws quell::Error.
  FrameFigures run(const FrameFamily& family, const FrameRuns& runs, const std::string& method);

 private:
  class Runner;
  Runner& runner(const std::string& method, bool halfInputs, bool faulty, const io::FrameData& example);

  std::string m_device;
  Options m_options;
  std::map<std::string, std::unique_ptr<Runner>> m_runners;
};

bool withinBounds(const FrameFigures& figures, const FrameFamily& family);

}  // namespace quell::stress
