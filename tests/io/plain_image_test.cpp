#include "host/io/plain_image.hpp"

#include <half.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "host/io/atomic_file.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using quell::Error;
using quell::ErrorCode;
using quell::tests::failsWith;
using quell::tests::noiseImage;
using quell::tests::samePixels;
using quell::tests::TemporaryDirectory;

namespace {

template <class Sample>
std::string bytesOf(const std::vector<Sample>& samples) {
  return {reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(Sample)};
}

}  // namespace

TEST_CASE("PFM keeps every bit", "[plain images]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.pfm");
  const Image image = noiseImage(7, 5, 3, 1, -1e30f, 1e30f);
  writePfm(path, image);
  CHECK(samePixels(readPfm(path), image));
  CHECK(readFile(path).rfind("PF\n7 5\n-1.0\n", 0) == 0);
  REQUIRE_THROWS_MATCHES(writePfm(path, noiseImage(7, 5, 2, 1)), Error,
                         failsWith(ErrorCode::InvalidArgument, {"a.pfm", "1 or 3 channels"}));
}

TEST_CASE("PFM of other programs: grey, four channels, big-endian, scaled, from the bottom up",
          "[plain images]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.pfm");
  writeTextFile(path, "Pf\n1 2\n-2\n" + bytesOf<float>({1.0f, 3.0f}));
  Image image = readPfm(path);
  CHECK(image.at(0, 0, 0) == 6.0f);
  CHECK(image.at(0, 1, 2) == 2.0f);
  writeTextFile(path, "PF4 1 1 -1.0\n" + bytesOf<float>({1.0f, 2.0f, 3.0f, 0.5f}));
  CHECK(readPfm(path).at(0, 0, 2) == 3.0f);
  writeTextFile(path, std::string("Pf\n1 1\n1\n\x3f\x80\x00\x00", 13));
  CHECK(readPfm(path).at(0, 0, 1) == 1.0f);
  for (const std::string& broken :
       {std::string(), std::string("PF"), std::string("P6\n1 1\n255\n"), std::string("PF\n1 1\n0\n"),
        std::string("PF\n-1 1\n-1\n"), std::string("PF\n1x 1\n-1\n"), std::string("PF\n1 1\n-1\nshort"),
        std::string("PF\n99999999 99999999\n-1\n"), std::string("PF\n1 1\nnan\n")}) {
    INFO(broken);
    writeTextFile(path, broken);
    REQUIRE_THROWS_MATCHES(readPfm(path), Error, failsWith(ErrorCode::FileError, {"a.pfm"}));
  }
}

TEST_CASE("raw samples are told apart by their number", "[plain images]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.raw");
  writeTextFile(path, bytesOf<float>({1.0f, 2.0f, 3.0f, 9.0f}));
  CHECK(readRaw(path, 1, 1).pixels == std::vector<float>{1.0f, 2.0f, 3.0f});
  writeTextFile(path, bytesOf<half>({half(1.0f), half(2.0f), half(3.0f)}));
  CHECK(readRaw(path, 1, 1).pixels == std::vector<float>{1.0f, 2.0f, 3.0f});
  REQUIRE_THROWS_MATCHES(readRaw(path, 2, 1), Error,
                         failsWith(ErrorCode::FileError, {"a.raw", "2x1", "24, 32, 12 or 16", "6 bytes"}));
}
