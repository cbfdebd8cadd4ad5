// What the commands denoise and bench say about time and error, as text and as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/cli/common/denoise_session.hpp"
#include "host/io/frame_sequence.hpp"
#include "host/metrics/motion_compensated.hpp"
#include "host/metrics/report.hpp"

namespace quell::cli {

/// Figures of one frame that has a reference.
struct FrameErrors {
  int frame = 0;
  metrics::ErrorFigures noisy;                              ///< the input itself
  metrics::ErrorFigures linear;                             ///< before TAA
  metrics::ErrorFigures display;                            ///< after TAA, where that is on
  io::ReferenceKind reference = io::ReferenceKind::Centre;  ///< what all three are compared with
};

/// Compares the input and both outputs of one frame with its reference. The input must not be demodulated.
FrameErrors compareFrame(const io::FrameData& frame, const DenoisedFrame& denoised,
                         const io::Reference& reference);

/// What the motion-compensated temporal error needs of a frame: the picture before TAA and its guides.
metrics::TrackedFrame trackFrame(const io::FrameData& frame, const DenoisedFrame& denoised);

struct DenoiseReport {
  DeviceInfo device;
  Settings settings;
  Size size;
  std::size_t frames = 0;
  MemoryUse memory;
  std::string outputHash;
  std::optional<Timings> timings;
  std::optional<double> copyMs;   ///< the unit *copy*, see host/measure/copy_bandwidth.hpp
  std::optional<double> copyGbs;  ///< GB/s
  std::vector<FrameErrors> errors;
  std::optional<double> temporalError;  ///< motion-compensated, before TAA, see MotionCompensatedErrorMeter
};

/// All stages of a frame taken together: sums of their statistics and bytes, gaps between stages left out.
StageTimings sumOfStages(const Timings& timings);

/// Bytes per time, 1e9 bytes per second; 0 without a time.
double gigabytesPerSecond(std::uint64_t bytes, const TimeStatistics& time);

const char* toString(TimeSource source);  ///< "device" or "host"
nlohmann::json toJson(const Timings& timings);
nlohmann::json toJson(const DenoiseReport& report);
std::string toText(const DenoiseReport& report);
void print(const DenoiseReport& report);  ///< its text

}  // namespace quell::cli
