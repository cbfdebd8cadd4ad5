// Runs a whole method over a sequence in host memory, for tests.
#pragma once

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numeric>
#include <quell/quell.hpp>
#include <vector>

#include "host/analytic/sequence.hpp"
#include "host/cli/common/denoise_session.hpp"
#include "host/metrics/display_encoding.hpp"

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

constexpr float kMostRadiance = 65504.0f;

/// 0, 1 ... count - 1.
inline std::vector<int> firstFrames(int count) {
  std::vector<int> frames(static_cast<std::size_t>(count));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

/// Of the pictures as they are displayed.
inline double encodedRmse(const io::Image& a, const io::Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double difference = metrics::encodeDisplay(a.pixels[i]) - metrics::encodeDisplay(b.pixels[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

/// Values that break careless code; the last ones are fireflies, which a history keeps for long.
constexpr int kPoisons = 6, kPoisonsWithoutFireflies = 4;

/// Puts them into pixels of all images of the first three frames.
inline void breakPixels(io::FrameData& frame, int poisons = kPoisons) {
  if (frame.number > 2) return;
  const float infinity = std::numeric_limits<float>::infinity();
  const float poison[kPoisons] = {
      std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -3.0f, 1e30f, 3e38f};
  const int width = frame.radiance.width, height = frame.radiance.height;
  io::Image* const images[] = {&frame.radiance, &frame.normalWorld, &frame.positionWorld,  &frame.albedo,
                               &frame.emission, &frame.roughness,   &frame.glossyRadiance, &frame.glossColor};
  for (int k = 0; k < poisons; ++k) {
    for (int i = 0; i < 8; ++i) {
      if (images[i]->empty()) continue;
      images[i]->at((17 * k + 13 * i + frame.number) % width, (11 * k + 7 * i) % height,
                    i % images[i]->channels) = poison[k];
    }
  }
}

/// True if every sample is finite and within [0, most].
inline bool isClean(const io::Image& image, float most) {
  for (const float value : image.pixels)
    if (!(value >= 0.0f && value <= most)) return false;
  return true;
}

}  // namespace quell::tests
