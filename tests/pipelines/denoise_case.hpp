// Runs a whole method over a sequence in host memory, for tests.
#pragma once

#include <functional>
#include <quell/quell.hpp>
#include <vector>

#include "host/cli/denoise_session.hpp"
#include "host/io/analytic_sequence.hpp"

namespace quell::tests {

/// Outputs of all frames and the hash over them.
struct DenoisedSequence {
  std::vector<cli::DenoisedFrame> frames;
  std::string hash;
};

/// `edit` may change a frame before it is denoised.
inline DenoisedSequence denoiseSequence(const io::FrameSequence& sequence, const std::vector<int>& frames,
                                        const Settings& settings = Settings("bmfr"),
                                        const Options& options = {},
                                        const std::function<void(io::FrameData&)>& edit = {}) {
  const char* spec = std::getenv("QUELL_TEST_DEVICE");
  DenoisedSequence result;
  cli::OutputHash hash;
  std::unique_ptr<cli::DenoiseSession> session;
  for (const int number : frames) {
    io::FrameData frame = sequence.read(number);
    if (edit) edit(frame);
    if (!session)
      session = std::make_unique<cli::DenoiseSession>(spec != nullptr ? spec : "", settings, options, frame);
    result.frames.push_back(session->denoise(frame));
    hash.add(result.frames.back().linear);
    hash.add(result.frames.back().display);
  }
  result.hash = hash.text();
  return result;
}

/// A built-in sequence of this size.
inline std::unique_ptr<io::FrameSequence> analyticSequence(
    int width, int height, int frameCount, std::array<double, 3> worldOffset = {0.0, 0.0, 0.0},
    int referenceSamples = 0, bool movingCamera = true) {
  io::AnalyticOptions options;
  options.width = width;
  options.height = height;
  options.frameCount = frameCount;
  options.worldOffset = worldOffset;
  options.referenceSamples = referenceSamples;
  options.movingCamera = movingCamera;
  return io::makeAnalyticSequence(options);
}

/// True if every sample is finite and within [0, most].
inline bool isClean(const io::Image& image, float most) {
  for (const float value : image.pixels)
    if (!(value >= 0.0f && value <= most)) return false;
  return true;
}

}  // namespace quell::tests
