#include "host/io/png_image.hpp"

#include <png.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>

#include "host/io/atomic_file.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using quell::Error;
using quell::ErrorCode;
using quell::tests::failsWith;
using quell::tests::noiseImage;
using quell::tests::TemporaryDirectory;

namespace {

/// Writes one row as libpng wants it: samples as bytes, 16-bit ones with the high byte first.
void writeRow(const std::string& path, int colorType, int bitDepth, int width, std::vector<png_byte> row) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, png_uint_32(width), 1, bitDepth, colorType, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_gAMA(png, info, 1.0);  // must not change what is read
  const png_color palette[2] = {{255, 0, 51}, {0, 255, 102}};
  if (colorType == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
  png_write_info(png, info);
  png_write_row(png, row.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
}

void requirePixel(const Image& image, int x, float r, float g, float b) {
  REQUIRE(image.at(x, 0, 0) == r);
  REQUIRE(image.at(x, 0, 1) == g);
  REQUIRE(image.at(x, 0, 2) == b);
}

}  // namespace

TEST_CASE("8-bit values survive a PNG and others are rounded to the nearest") {
  const TemporaryDirectory directory;
  Image image(256, 2, 3);
  for (int x = 0; x < 256; ++x)
    for (int c = 0; c < 3; ++c) {
      image.at(x, 0, c) = float(x) / 255.0f;
      image.at(x, 1, c) = (float(x) + (c == 0 ? 0.45f : -0.45f)) / 255.0f;
    }
  writePng(directory.file("a.png"), image);
  const Image read = readPng(directory.file("a.png"));
  for (int x = 1; x < 255; ++x) {
    REQUIRE(read.at(x, 0, 0) == float(x) / 255.0f);
    REQUIRE(read.at(x, 1, 0) == float(x) / 255.0f);
    REQUIRE(read.at(x, 1, 1) == float(x) / 255.0f);
  }
}

TEST_CASE("values outside the range are clamped and NaN becomes black") {
  const TemporaryDirectory directory;
  Image image(1, 1, 3);
  image.pixels = {-3.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()};
  writePng(directory.file("a.png"), image);
  requirePixel(readPng(directory.file("a.png")), 0, 0.0f, 1.0f, 0.0f);
}

TEST_CASE("every colour type is read as encoded RGB") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.png");
  SECTION("8-bit grey") {
    writeRow(path, PNG_COLOR_TYPE_GRAY, 8, 2, {51, 255});
    requirePixel(readPng(path), 0, 0.2f, 0.2f, 0.2f);
  }
  SECTION("1-bit grey") {
    writeRow(path, PNG_COLOR_TYPE_GRAY, 1, 2, {0x40});
    requirePixel(readPng(path), 1, 1.0f, 1.0f, 1.0f);
  }
  SECTION("alpha is dropped") {
    writeRow(path, PNG_COLOR_TYPE_RGBA, 8, 1, {255, 0, 51, 0});
    requirePixel(readPng(path), 0, 1.0f, 0.0f, 0.2f);
  }
  SECTION("palette") {
    writeRow(path, PNG_COLOR_TYPE_PALETTE, 8, 2, {1, 0});
    requirePixel(readPng(path), 0, 0.0f, 1.0f, 0.4f);
    requirePixel(readPng(path), 1, 1.0f, 0.0f, 0.2f);
  }
  SECTION("16 bits keep their precision") {
    writeRow(path, PNG_COLOR_TYPE_RGB, 16, 1, {0x12, 0x34, 0xff, 0xff, 0x00, 0x01});
    requirePixel(readPng(path), 0, float(0x1234) / 65535.0f, 1.0f, 1.0f / 65535.0f);
  }
}

TEST_CASE("a missing, foreign or truncated PNG is an error, at every length") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.png");
  REQUIRE_THROWS_MATCHES(readPng(path), Error, failsWith(ErrorCode::FileError, {"a.png", "no such file"}));
  writePng(path, noiseImage(23, 19, 3, 1));
  const std::string bytes = readFile(path);
  for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 50) {
    writeTextFile(path, bytes.substr(0, length));
    REQUIRE_THROWS_MATCHES(readPng(path), Error, failsWith(ErrorCode::FileError, {"a.png"}));
  }
}

TEST_CASE("pictures that cannot be written are refused") {
  const TemporaryDirectory directory;
  REQUIRE_THROWS_MATCHES(writePng(directory.file("a.png"), Image(2, 2, 1)), Error,
                         failsWith(ErrorCode::InvalidArgument, {"1 channels"}));
  REQUIRE_THROWS_MATCHES(writePng(directory.file("a.png"), Image()), Error,
                         failsWith(ErrorCode::InvalidArgument));
  REQUIRE_THROWS_MATCHES(writePng(directory.file("missing/a.png"), Image(2, 2, 3)), Error,
                         failsWith(ErrorCode::FileError));
}
