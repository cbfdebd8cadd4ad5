// What a still camera that jitters sees is averaged over the pixel.
#include <catch2/catch.hpp>

#include "host/metrics/error.hpp"
#include "tests/pipelines/denoise_case.hpp"

namespace quell::tests {
namespace {

constexpr int kWidth = 97, kHeight = 61, kFrames = 16;

std::unique_ptr<io::FrameSequence> stillSequence(bool jitter) {
  io::AnalyticOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.frameCount = kFrames;
  options.movingCamera = false;
  options.jitter = jitter;
  options.referenceSamples = 64;
  return io::makeAnalyticSequence(options);
}

}  // namespace

TEST_CASE("the display of a still camera that jitters is antialiased", "[pipelines]") {
  const io::Reference reference = stillSequence(true)->reference(kFrames - 1, io::ReferenceKind::Antialiased);
  const auto errorOf = [&](const char* method, bool jitter) {
    const auto result = denoiseSequence(*stillSequence(jitter), firstFrames(kFrames), Settings(method));
    return metrics::rmse(result.frames.back().display, metrics::encodeForDisplay(reference.a));
  };
  for (const char* method : {"quell", "svgf"}) {
    INFO(method << ": jittered " << errorOf(method, true) << ", through pixel centres "
                << errorOf(method, false));
    CHECK(errorOf(method, true) < 0.85 * errorOf(method, false));
  }
}

}  // namespace quell::tests
