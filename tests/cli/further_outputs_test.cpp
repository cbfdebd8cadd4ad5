// What `quell denoise` writes for other programs.
#include <catch2/catch.hpp>
#include <filesystem>

#include "host/io/exr_image.hpp"
#include "host/io/plain_image.hpp"
#include "tests/support/multilayer_files.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

io::Image passOf(const std::string& file, const std::string& name) {
  return io::readExr(file, {name + ".R", name + ".G", name + ".B"});
}

}  // namespace

TEST_CASE("denoise writes PFM, the history before the filter, and a multilayer file", "[cli]") {
  const TemporaryDirectory directory;
  const std::string input = directory.file("in"), out = directory.file("out");
  std::filesystem::create_directory(input);
  const auto sequence = multilayer::builtIn();
  for (const int frame : {1, 2})
    multilayer::writeMultilayer(input + "/" + std::to_string(frame) + ".exr",
                                multilayer::passesOf(sequence->read(frame)));
  REQUIRE(quell({"denoise", "--input", input, "--output", out, "--float", "--pfm", "--accumulated",
                 "--multilayer"}) == 0);
  const std::string multilayer = out + "/multilayer_0002.exr";
  const io::Image denoised = io::readExr(out + "/denoised_0002.exr");
  CHECK(samePixels(io::readPfm(out + "/denoised_0002.pfm"), denoised));
  CHECK(samePixels(passOf(multilayer, "View Layer.Denoised"), denoised));
  CHECK(
      samePixels(passOf(multilayer, "View Layer.Combined"), passOf(input + "/2.exr", "View Layer.Combined")));
  const io::Image accumulated = io::readExr(out + "/accumulated_0002.exr");
  CHECK(samePixels(passOf(multilayer, "View Layer.Accumulated"), accumulated));
  CHECK_FALSE(samePixels(accumulated, denoised));

  // The first frame has no history: what is accumulated is what came.
  const io::Image first = io::readExr(out + "/accumulated_0001.exr"), noisy = sequence->read(1).radiance;
  for (std::size_t i = 0; i < first.pixels.size(); ++i)
    REQUIRE(first.pixels[i] == Approx(noisy.pixels[i]).epsilon(1e-3).margin(1e-4));
}

TEST_CASE("what --preroll takes in is not written, and counts as if it were", "[cli]") {
  const TemporaryDirectory directory;
  const std::string whole = directory.file("whole"), part = directory.file("part");
  const auto denoise = [&](const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"denoise", "--input",  kData, "--exr", "--accumulated", "--output",
                                          out,       "--timers", "off", "--set", "taa=on",        "--frames"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return errorStreamOf(arguments, 0, directory.file("stderr"));
  };
  denoise(whole, {"4-7"});
  const std::string silent = denoise(part, {"7", "--preroll", "3"});
  for (const char* picture : {"denoised", "display", "accumulated"}) {
    INFO(picture);
    const std::string file = std::string("/") + picture + "_0007.exr";
    CHECK(samePixels(io::readExr(part + file), io::readExr(whole + file)));
    CHECK_FALSE(std::filesystem::exists(part + "/" + picture + "_0006.exr"));
  }
  CHECK(silent.find("history") == std::string::npos);
  // More than there are: all of them.
  denoise(part, {"7", "--preroll", "99"});
  CHECK(samePixels(io::readExr(part + "/denoised_0007.exr"), io::readExr(whole + "/denoised_0007.exr")));
  CHECK(denoise(part, {"7"}).find("frame 7 begins without a history") != std::string::npos);
  CHECK(denoise(part, {"4"}).find("history") == std::string::npos);
  CHECK_FALSE(
      samePixels(io::readExr(part + "/denoised_0004.exr"), io::readExr(whole + "/denoised_0007.exr")));
}

TEST_CASE("a multilayer file is made of separate ones, with the denoised picture in front", "[cli]") {
  const TemporaryDirectory directory;
  const std::string out = directory.file("out");
  REQUIRE(quell({"denoise", "--input", kData, "--output", out, "--frames", "15", "--multilayer"}) == 0);
  const std::string multilayer = out + "/multilayer_0015.exr";
  CHECK(samePixels(io::readExr(multilayer, {"R", "G", "B"}), io::readExr(out + "/denoised_0015.exr")));
  CHECK(samePixels(passOf(multilayer, "world_position"), io::readExr(kData + "/world_position_0015.exr")));
  CHECK(samePixels(passOf(multilayer, "color"), io::readExr(kData + "/color_0015.exr")));
  CHECK(errorStreamOf({"denoise", "--multilayer", "--size", "8x8", "--output", out}, 1,
                      directory.file("stderr"))
            .find("--input") != std::string::npos);
  CHECK(errorStreamOf({"denoise", "--pfm", "--size", "8x8"}, 1, directory.file("stderr")).find("--output") !=
        std::string::npos);
}

}  // namespace quell::tests
