#include "host/io/exr_image.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>

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

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Largest relative rounding error of a normal half value (11 significant bits).
constexpr float kHalfRounding = 1.0f / 2048.0f;

/// A float image of named channels whose data window does not start at the origin.
void writeNamedChannels(const std::string& path, const std::vector<std::string>& names, const Image& image) {
  const Imath::Box2i window({-3, 5}, {image.width - 4, image.height + 4});
  Imf::Header header(window, window);
  Imf::FrameBuffer buffer;
  const std::size_t stride = names.size() * sizeof(float);
  for (std::size_t c = 0; c < names.size(); ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    char* base = reinterpret_cast<char*>(const_cast<float*>(image.pixels.data() + c));
    buffer.insert(names[c],
                  Imf::Slice::Make(Imf::FLOAT, base, window, stride, stride * std::size_t(image.width)));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(image.height);
}

/// A tiled image of one integer channel Y with the values 0, 1, 2, ...
void writeTiledIntegers(const std::string& path, int width, int height) {
  std::vector<unsigned> values(std::size_t(width) * std::size_t(height));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = unsigned(i);
  Imf::Header header(width, height);
  header.channels().insert("Y", Imf::Channel(Imf::UINT));
  header.setTileDescription(Imf::TileDescription(8, 4, Imf::ONE_LEVEL));
  Imf::TiledOutputFile file(path.c_str(), header);
  Imf::FrameBuffer buffer;
  buffer.insert("Y", Imf::Slice::Make(Imf::UINT, values.data(), header.dataWindow(), sizeof(unsigned),
                                      sizeof(unsigned) * std::size_t(width)));
  file.setFrameBuffer(buffer);
  file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

}  // namespace

TEST_CASE("float images survive unchanged, NaN and Inf included") {
  const TemporaryDirectory directory;
  for (int channels : {1, 2, 3}) {
    Image image = noiseImage(17, 9, channels, 1, -1e6f, 1e6f);
    image.pixels[0] = kNan;
    image.pixels[1] = kInf;
    writeExr(directory.file("a.exr"), image, ExrType::Float);
    REQUIRE(samePixels(readExr(directory.file("a.exr")), image));
  }
  REQUIRE(directory.entryCount() == 1);
}

TEST_CASE("channels may have any names, as many as the image has") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.exr");
  const Image image = noiseImage(7, 1, 4, 1);
  const std::vector<std::string> names = {"plane0", "plane1", "plane2", "plane3"};
  writeExr(path, image, names, ExrType::Float);
  REQUIRE(samePixels(readExr(path, names), image));
  REQUIRE_THROWS_MATCHES(writeExr(path, image, {"plane0"}, ExrType::Float), Error,
                         failsWith(ErrorCode::InvalidArgument, {"4 channels"}));
}

TEST_CASE("half images are rounded, clamped to the half range and keep NaN") {
  const TemporaryDirectory directory;
  Image image = noiseImage(16, 11, 3, 2, 0.1f, 1000.0f);
  image.at(0, 0, 0) = 1e9f;
  image.at(0, 0, 1) = kInf;
  image.at(0, 0, 2) = -kInf;
  image.at(1, 0, 0) = 65519.0f;  // still rounds down to the largest half
  image.at(1, 0, 1) = 65520.0f;  // would round to Inf
  image.at(1, 0, 2) = kNan;
  writeExr(directory.file("a.exr"), image);
  const Image read = readExr(directory.file("a.exr"));
  REQUIRE(read.at(0, 0, 0) == 65504.0f);
  REQUIRE(read.at(0, 0, 1) == 65504.0f);
  REQUIRE(read.at(0, 0, 2) == -65504.0f);
  REQUIRE(read.at(1, 0, 0) == 65504.0f);
  REQUIRE(read.at(1, 0, 1) == 65504.0f);
  REQUIRE(std::isnan(read.at(1, 0, 2)));
  for (std::size_t i = 6; i < image.pixels.size(); ++i)
    REQUIRE(std::abs(read.pixels[i] - image.pixels[i]) <= kHalfRounding * image.pixels[i]);
}

TEST_CASE("channels are found by name, wherever the data window lies") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.exr");
  const Image image = noiseImage(7, 5, 3, 3);
  writeNamedChannels(path, {"X", "Y", "Z"}, image);
  REQUIRE(samePixels(readExr(path), image));
  REQUIRE(samePixels(readExrRgb(path), image));
  REQUIRE(readExr(path, {"Z"}).at(6, 4, 0) == image.at(6, 4, 2));
  const ExrHeader header = readExrHeader(path);
  REQUIRE(header.width == 7);
  REQUIRE(header.height == 5);
  REQUIRE(header.channels == std::vector<std::string>{"X", "Y", "Z"});
}

TEST_CASE("integer channels and tiles become floats in scan-line order") {
  const TemporaryDirectory directory;
  writeTiledIntegers(directory.file("a.exr"), 19, 10);
  const Image image = readExr(directory.file("a.exr"));
  REQUIRE(image.channels == 1);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) REQUIRE(image.pixels[i] == float(i));
}

TEST_CASE("missing channels are an error that lists those present") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.exr");
  writeNamedChannels(path, {"U", "V", "R"}, noiseImage(4, 4, 3, 4));
  const auto missing = failsWith(ErrorCode::FileError, {"a.exr", "R G B", "only R U V"});
  REQUIRE_THROWS_MATCHES(readExr(path), Error, missing);
  REQUIRE_THROWS_MATCHES(readExrRgb(path), Error, missing);
  REQUIRE_THROWS_MATCHES(readExr(path, {"R", "A"}), Error,
                         failsWith(ErrorCode::FileError, {"channels R A", "only R U V"}));
  writeExr(path, noiseImage(4, 4, 2, 4));
  REQUIRE_THROWS_MATCHES(readExrRgb(path), Error, failsWith(ErrorCode::FileError, {"only G R"}));
}

TEST_CASE("a missing, foreign, empty or truncated file is an error, at every length") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.exr");
  REQUIRE_THROWS_MATCHES(readExr(path), Error, failsWith(ErrorCode::FileError, {"a.exr", "no such file"}));
  REQUIRE_THROWS_MATCHES(readExr(directory.path()), Error, failsWith(ErrorCode::FileError));
  writeExr(path, noiseImage(40, 40, 3, 5));
  const std::string bytes = readFile(path);
  for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 50) {
    writeTextFile(path, bytes.substr(0, length));
    REQUIRE_THROWS_MATCHES(readExr(path), Error, failsWith(ErrorCode::FileError, {"a.exr"}));
  }
  writeTextFile(path, "certainly not an image");
  REQUIRE_THROWS_MATCHES(readExr(path), Error, failsWith(ErrorCode::FileError, {"a.exr"}));
}

TEST_CASE("a header that claims a huge image is refused before memory is taken for it") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.exr");
  Imf::Header header(1, 1);
  header.dataWindow() = Imath::Box2i({0, 0}, {1000000, 1000});
  header.channels().insert("Y", Imf::Channel(Imf::HALF));
  { Imf::OutputFile file(path.c_str(), header); }
  REQUIRE_THROWS_MATCHES(readExr(path), Error, failsWith(ErrorCode::FileError, {"1000001x1001"}));
}

TEST_CASE("a picture of one colour is read, however little of it is left in the file") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.exr");
  const int width = 4096, height = 512;
  const std::vector<half> black(std::size_t(width) * std::size_t(height));
  for (const Imf::Compression compression :
       {Imf::ZIP_COMPRESSION, Imf::PXR24_COMPRESSION, Imf::DWAB_COMPRESSION}) {
    Imf::Header header(width, height);
    header.compression() = compression;
    header.channels().insert("Y", Imf::Channel(Imf::HALF));
    {
      Imf::OutputFile file(path.c_str(), header);
      Imf::FrameBuffer buffer;
      buffer.insert("Y", Imf::Slice::Make(Imf::HALF, black.data(), header.dataWindow()));
      file.setFrameBuffer(buffer);
      file.writePixels(height);
    }
    CHECK(std::filesystem::file_size(path) < 20000);
    CHECK(samePixels(readExr(path, {"Y"}), Image(width, height, 1)));
  }
}

TEST_CASE(
    "attributes longer than the file, or than their type, are refused before memory is taken for them") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.exr");
  writeExr(path, Image(2, 2, 3));
  const std::string bytes = readFile(path);
  // The length stands behind the names of the attribute and of its type, little-endian.
  const auto withLength = [&](const std::string& names, const std::string& length) {
    std::string changed = bytes;
    const std::size_t begin = changed.find(names);
    REQUIRE(begin != std::string::npos);
    changed.replace(begin + names.size(), length.size(), length);
    writeTextFile(path, changed);
  };
  const std::string pixelAspect("pixelAspectRatio\0float\0", 23);
  withLength(pixelAspect, std::string("\0\0\0\x70", 4));
  REQUIRE_THROWS_MATCHES(readExr(path), Error, failsWith(ErrorCode::FileError, {"a.exr"}));
  withLength(pixelAspect, std::string("\x05\0\0\0", 4));
  REQUIRE_THROWS_MATCHES(readExr(path), Error, failsWith(ErrorCode::FileError, {"a.exr"}));
  withLength(std::string("channels\0chlist\0", 16), std::string("\x13\0\0\0", 4));
  REQUIRE_THROWS_MATCHES(readExr(path), Error, failsWith(ErrorCode::FileError, {"a.exr"}));
}

TEST_CASE("images that cannot be written are refused") {
  const TemporaryDirectory directory;
  REQUIRE_THROWS_MATCHES(writeExr(directory.file("a.exr"), Image()), Error,
                         failsWith(ErrorCode::InvalidArgument));
  REQUIRE_THROWS_MATCHES(writeExr(directory.file("a.exr"), Image(2, 2, 4)), Error,
                         failsWith(ErrorCode::InvalidArgument, {"4 channels"}));
  REQUIRE_THROWS_MATCHES(writeExr(directory.file("missing/a.exr"), Image(2, 2, 3)), Error,
                         failsWith(ErrorCode::FileError, {"missing"}));
  REQUIRE(directory.entryCount() == 0);
}
