// Do the windows of the fit show? Without history, the step of the error across window borders is compared
// with the step elsewhere.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "host/io/frame_sequence.hpp"
#include "host/metrics/display_encoding.hpp"
#include "host/stages/gram_windows.hpp"
#include "tests/pipelines/denoise_case.hpp"
#include "tests/support/further_sequences.hpp"

namespace quell::tests {
namespace {

constexpr int kOffsets = 16;
// Mean step on borders over mean step off borders; 1 means that the borders cannot be told from anything
// else.
constexpr double kInvisible = 0.03;

struct Grid {
  int firstX, firstY, edge;
  bool isBorder(int position, int first) const { return (position - first) % edge == 0; }
};

// Mean absolute step of the encoded error between neighbours, across borders over elsewhere.
double borderRatio(const io::Image& output, const io::Reference& reference, Grid grid) {
  double sum[2] = {0.0, 0.0};
  double count[2] = {0.0, 0.0};
  const auto error = [&](int x, int y, int c) {
    const float mean = 0.5f * (reference.a.at(x, y, c) + reference.b.at(x, y, c));
    return double{metrics::encodeDisplay(output.at(x, y, c))} - double{metrics::encodeDisplay(mean)};
  };
  for (int y = 1; y < output.height; ++y) {
    for (int x = 1; x < output.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const bool borderX = grid.isBorder(x, grid.firstX), borderY = grid.isBorder(y, grid.firstY);
        sum[borderX] += std::abs(error(x, y, c) - error(x - 1, y, c));
        sum[borderY] += std::abs(error(x, y, c) - error(x, y - 1, c));
        count[borderX] += 1.0;
        count[borderY] += 1.0;
      }
    }
  }
  return (sum[1] / count[1]) / (sum[0] / count[0]);
}

// A frame without a surface leaves no history but moves the block grid on.
io::FrameData withoutSurfaces(io::FrameData frame) {
  for (float& component : frame.normalWorld.pixels) component = 0.0f;
  return frame;
}

double meanBorderRatio(const io::FrameSequence& sequence, const Settings& settings) {
  const io::FrameData frame = sequence.read(15);
  const auto reference = sequence.reference(15, io::ReferenceKind::Centre);
  const Size size = {sequence.width(), sequence.height()};
  const bool overlap = settings.text("windows") == "overlap";
  const char* spec = std::getenv("QUELL_TEST_DEVICE");
  double sum = 0.0;
  for (int offset = 0; offset < kOffsets; ++offset) {
    cli::DenoiseSession session(spec != nullptr ? spec : "", settings, {}, frame);
    for (int i = 0; i < offset; ++i) session.denoise(withoutSurfaces(frame));
    const int edge = overlap ? std::stoi(settings.text("tileSize")) : QUELL_BLOCK_EDGE;
    const GramParams tiles = makeGramParams({overlap, edge}, size, static_cast<std::uint32_t>(offset), 0.0);
    const Grid grid = {tiles.tileOffsetX, tiles.tileOffsetY, edge};
    sum += borderRatio(session.denoise(frame).linear, reference, grid);
  }
  return sum / kOffsets;
}

Settings gramOverlap() {
  Settings settings("bmfr");
  settings.set("solver", "gram");
  settings.set("windows", "overlap");
  return settings;
}

}  // namespace

// Of larger pictures; only the mean over them is held to a bound: a picture's own edges fall on borders by chance.
TEST_CASE("window borders of the further sequences", "[pipelines][.sequences]") {
  const std::vector<std::string> directories = furtherSequences("ref_a_color_0015.exr");
  if (directories.empty()) return;
  double sum = 0.0;
  for (const std::string& directory : directories) {
    const auto sequence = io::openSequence(directory);
    const double blended = meanBorderRatio(*sequence, gramOverlap());
    const double blocks = meanBorderRatio(*sequence, Settings("bmfr"));
    WARN(directory << ": step across window borders over step elsewhere: overlap " << blended
                   << ", householder blocks " << blocks);
    CHECK(std::abs(blended - 1.0) < std::abs(blocks - 1.0));
    sum += blended;
  }
  CHECK(std::abs(sum / static_cast<double>(directories.size()) - 1.0) < kInvisible);
}

TEST_CASE("overlapping windows show no borders without history", "[pipelines]") {
  const auto sequence = io::openSequence(std::string(QUELL_DATA_DIR) + "/colonnade");
  const double blended = meanBorderRatio(*sequence, gramOverlap());
  const double blocks = meanBorderRatio(*sequence, Settings("bmfr"));
  WARN("step across window borders over step elsewhere: overlap " << blended << ", householder blocks "
                                                                  << blocks);
  CHECK(std::abs(blended - 1.0) < kInvisible);
  CHECK(blocks > 1.0 + kInvisible);
}

}  // namespace quell::tests
