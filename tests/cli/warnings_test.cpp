// Sequences with frames that are out of the ordinary, through the tool: it goes on, and says once what is wrong.
#include <ImfChannelList.h>
#include <ImfInputFile.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "host/io/exr_image.hpp"
#include "tests/support/multilayer_files.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

using multilayer::kHeight;
using multilayer::kWidth;

int countOf(const std::string& part, const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// Four frames with alpha, the second and the third without any surface that a camera could follow from.
void writeFrames(const TemporaryDirectory& input, const io::Image& alpha) {
  const auto sequence = multilayer::builtIn();
  for (int number = 0; number < 4; ++number) {
    multilayer::Passes passes = multilayer::passesOf(sequence->read(number));
    io::Image rgba(kWidth, kHeight, 4);
    for (std::size_t i = 0; i < rgba.pixels.size(); ++i)
      rgba.pixels[i] = i % 4 == 3 ? alpha.pixels[i / 4] : passes["Combined"].pixels[i / 4 * 3 + i % 4];
    passes["Combined"] = rgba;
    if (number == 1 || number == 2) passes["Depth"] = io::Image(kWidth, kHeight, 1, 1e10f);
    multilayer::writeMultilayer(input.file("000" + std::to_string(number) + ".exr"), passes);
  }
}

Imf::PixelType typeOf(const std::string& path, const char* channel) {
  const Imf::InputFile file(path.c_str());
  return file.header().channels()[channel].type;
}

}  // namespace

TEST_CASE("a run goes on past frames without a camera, says so once and keeps alpha", "[cli]") {
  const TemporaryDirectory input, other;
  const std::string out = other.file("out");
  const io::Image alpha = noiseImage(kWidth, kHeight, 1, 3);
  writeFrames(input, alpha);
  const std::string text =
      errorStreamOf({"denoise", "--input", input.path(), "--output", out, "--exr", "--png", "--float"}, 0,
                    other.file("stderr"));
  CHECK(countOf("quell: warning: ", text) == 1);
  CHECK_THAT(text, Catch::Contains("0001.exr") && Catch::Contains("no surfaces") &&
                       Catch::Contains("that of frame 0"));
  for (const char* name : {"/denoised_0003.exr", "/display_0003.exr"}) {
    CHECK(samePixels(io::readExr(out + name, {"A"}), alpha));
    CHECK(typeOf(out + name, "R") == Imf::FLOAT);
    CHECK(typeOf(out + name, "A") == Imf::FLOAT);
  }
}

TEST_CASE("floats are written on demand alone, and dark light survives in them", "[cli]") {
  const TemporaryDirectory directory;
  const std::string out = directory.file("out"), file = out + "/denoised_0001.exr";
  const std::vector<std::string> arguments = {"denoise", "--size",   "40x30", "--frame-count",
                                              "2",       "--output", out};
  REQUIRE(quell(arguments) == 0);
  CHECK(typeOf(file, "R") == Imf::HALF);
  const io::Image half = io::readExr(file);
  std::vector<std::string> more = arguments;
  more.push_back("--float");
  REQUIRE(quell(more) == 0);
  CHECK(typeOf(file, "R") == Imf::FLOAT);
  const io::Image floats = io::readExr(file);
  for (std::size_t i = 0; i < half.pixels.size(); ++i)
    REQUIRE(floats.pixels[i] == Approx(half.pixels[i]).epsilon(1.0 / 2048.0).margin(1e-7));
  CHECK_FALSE(samePixels(half, floats));
}

TEST_CASE("noise that stays the same is reported, and history does without it", "[cli]") {
  const TemporaryDirectory input, other;
  const std::string json = other.file("report.json"), out = other.file("out");
  io::AnalyticOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.movingCamera = false;
  const multilayer::Passes passes = multilayer::passesOf(io::makeAnalyticSequence(options)->read(0));
  for (const char* name : {"0000.exr", "0001.exr", "0002.exr"})
    multilayer::writeMultilayer(input.file(name), passes);
  const std::string text =
      errorStreamOf({"denoise", "--input", input.path(), "--output", out}, 0, other.file("stderr"));
  CHECK(countOf("quell: warning: ", text) == 1);
  CHECK_THAT(text, Catch::Contains("0001.exr") && Catch::Contains("noise") && Catch::Contains("seed"));
  // Each as good as a first frame.
  CHECK(samePixels(io::readExr(out + "/denoised_0002.exr"), io::readExr(out + "/denoised_0000.exr")));
}

}  // namespace quell::tests
