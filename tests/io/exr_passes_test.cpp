#include "host/io/exr_passes.hpp"

#include <catch2/catch.hpp>

#include "host/io/exr_image.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/exr_parts.hpp"
#include "tests/support/multilayer_files.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using quell::Error;
using quell::ErrorCode;
using quell::tests::failsWith;
using quell::tests::noiseImage;
using quell::tests::samePixels;
using quell::tests::TemporaryDirectory;
using namespace quell::tests::multilayer;

TEST_CASE("a file is written anew with a pass beside all that it has", "[exr passes]") {
  const TemporaryDirectory directory;
  const std::string input = directory.file("in.exr"), output = directory.file("out.exr");
  Passes passes = {{"Combined", noiseImage(kWidth, kHeight, 4, 1)},
                   {"CryptoObject00", noiseImage(kWidth, kHeight, 3, 2)}};
  writeMultilayer(input, passes);
  const ExrHeader header = readExrHeader(input);
  const Image denoised = noiseImage(kWidth, kHeight, 3, 3);
  const std::string name = passBeside(header.channels, "Denoised");
  CHECK(name == "View Layer.Denoised");
  writeWithPasses(input, output, {{name, {"R", "G", "B"}, denoised, ExrType::Float}});
  CHECK(readExrHeader(output).channels.size() == header.channels.size() + 3);
  CHECK(samePixels(readExr(output, {name + ".R", name + ".G", name + ".B"}), denoised));
  CHECK(samePixels(readExr(output, header.channels), readExr(input, header.channels)));
  REQUIRE_THROWS_MATCHES(writeWithPasses(output, output, {{name, {"R", "G", "B"}, denoised}}), Error,
                         failsWith(ErrorCode::FileError, {"out.exr", "two channels View Layer.Denoised.R"}));
  REQUIRE_THROWS_MATCHES(writeWithPasses(input, output, {{name, {"Y"}, noiseImage(3, 3, 1, 1)}}), Error,
                         failsWith(ErrorCode::FileError, {"in.exr", "3x3", "61x40"}));
}

TEST_CASE("a file of several parts has a pass as a part of its own", "[exr passes]") {
  const TemporaryDirectory directory;
  const std::string input = directory.file("in.exr"), output = directory.file("out.exr");
  quell::tests::Planes combined, depth;
  quell::tests::addPlanes(combined, "", noiseImage(8, 5, 3, 1), "RGB");
  quell::tests::addPlanes(depth, "", noiseImage(8, 5, 1, 2), "Z");
  quell::tests::writeParts(input, {{"L.Combined", combined}, {"L.Depth", depth}});
  const ExrHeader header = readExrHeader(input);
  const std::string name = passBeside(header.channels, "Denoised");
  CHECK(name == "L.Denoised");
  writeWithPasses(input, output, {{name, {"R", "G", "B"}, noiseImage(8, 5, 3, 3), ExrType::Float}});
  CHECK(readExrHeader(output).parts.size() == 3);
  CHECK(
      samePixels(readExr(output, {"L.Denoised.R", "L.Denoised.G", "L.Denoised.B"}), noiseImage(8, 5, 3, 3)));
  CHECK(samePixels(readExr(output, {"L.Depth.Z"}), noiseImage(8, 5, 1, 2)));
}

TEST_CASE("what stands beside the picture as a whole has its layer", "[exr passes]") {
  CHECK(passBeside({"A.Depth.Z", "A.Combined.R"}, "Denoised") == "A.Denoised");
  CHECK(passBeside({"Combined.R"}, "Denoised") == "Denoised");
  CHECK(passBeside({"R", "NotCombined.R"}, "Denoised") == "Denoised");
}
