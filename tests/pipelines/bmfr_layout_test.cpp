// The layout published with the BMFR paper's data set, end to end: a generated directory in that layout
// denoises like the same frames handed over directly.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "host/io/exr_image.hpp"
#include "host/io/frame_sequence.hpp"
#include "host/metrics/display_encoding.hpp"
#include "tests/pipelines/denoise_case.hpp"
#include "tests/support/temporary_directory.hpp"

namespace quell::tests {
namespace {

constexpr int kFrames = 4;

// Published data has albedo divided out; where it is zero nothing is left.
io::FrameData demodulated(io::FrameData frame) {
  for (std::size_t i = 0; i < frame.radiance.pixels.size(); ++i) {
    const float albedo = frame.albedo.pixels[i];
    const float signal = frame.radiance.pixels[i] - frame.emission.pixels[i];
    frame.radiance.pixels[i] = albedo > 0.0f ? signal / albedo : 0.0f;
  }
  frame.emission = io::Image();
  frame.demodulated = true;
  return frame;
}

void writeFrame(const std::string& directory, const io::FrameData& frame) {
  const auto path = [&](const char* name) {
    return directory + "/" + name + std::to_string(frame.number) + ".exr";
  };
  io::writeExr(path("color"), frame.radiance, io::ExrType::Float);
  io::writeExr(path("shading_normal"), frame.normalWorld, io::ExrType::Float);
  io::writeExr(path("world_position"), frame.positionWorld, io::ExrType::Float);
  io::writeExr(path("albedo"), frame.albedo, io::ExrType::Float);
}

// Column-major, so element [c][r] is row r, column c; the published images are not flipped, so clip.y is
// negated.
void writeMatrices(const std::string& directory, const std::vector<io::FrameData>& frames) {
  std::ofstream file(directory + "/camera_matrices.h");
  file.precision(17);
  file << "const float camera_matrices[" << frames.size() << "][4][4] = {\n";
  for (const io::FrameData& frame : frames) {
    file << "  {";
    for (int c = 0; c < 4; ++c) {
      file << "{";
      for (int r = 0; r < 4; ++r)
        file << (r == 1 ? -1.0 : 1.0) * frame.camera.worldToClip[4 * r + c] << (r < 3 ? ", " : "");
      file << "}" << (c < 3 ? ", " : "");
    }
    file << "},\n";
  }
  file << "};\nconst float pixel_offsets[" << frames.size() << "][2] = {\n";
  for (std::size_t i = 0; i < frames.size(); ++i) file << "  {0.5, 0.5},\n";
  file << "};\nconst float position_limit_squared = 0.01f;\nconst float normal_limit_squared = 0.1f;\n";
}

double rmse(const io::Image& a, const io::Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    sum += std::pow(double{a.pixels[i]} - double{b.pixels[i]}, 2);
  return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

}  // namespace

TEST_CASE("the published layout denoises like the same frames in memory", "[pipelines]") {
  const auto source = analyticSequence(96, 64, kFrames);
  const TemporaryDirectory directory;
  std::vector<io::FrameData> frames;
  for (int i = 0; i < kFrames; ++i) {
    frames.push_back(demodulated(source->read(i)));
    writeFrame(directory.path(), frames.back());
  }
  writeMatrices(directory.path(), frames);

  const auto sequence = io::openSequence(directory.path());
  const auto limits = sequence->historyLimits();
  REQUIRE(limits);
  Settings settings("bmfr");
  settings.set("positionLimit", std::sqrt(limits->positionSquared));
  settings.set("normalLimitSquared", limits->normalSquared);
  const DenoisedSequence fromFiles = denoiseSequence(*sequence, {0, 1, 2, 3}, settings);
  const DenoisedSequence direct = denoiseSequence(*source, {0, 1, 2, 3}, settings, {},
                                                  [](io::FrameData& frame) { frame = demodulated(frame); });
  // Matrices pass through text and the camera position is solved for again: equal up to rounding, which can
  // flip a discard decision here and there. A wrong convention would reject the history and differ by the
  // noise.
  const double difference = rmse(fromFiles.frames.back().display, direct.frames.back().display);
  const double noise = rmse(direct.frames.front().display, direct.frames.back().display);
  INFO("difference " << difference << ", from frame to frame " << noise);
  CHECK(difference < 0.1 * noise);
}

}  // namespace quell::tests
