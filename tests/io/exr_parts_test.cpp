// Parts, windows and attributes of OpenEXR files.
#include "tests/support/exr_parts.hpp"

#include <ImfStandardAttributes.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using namespace quell::tests;
using quell::Camera;
using quell::Error;
using quell::ErrorCode;

TEST_CASE("channels of all parts have names of their own, views included") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.exr");
  const Image color = noiseImage(5, 4, 3, 1), normal = noiseImage(5, 4, 3, 2), other = noiseImage(5, 4, 3, 3);
  Planes blender, bare, left;
  addPlanes(blender, "Layer.Combined", color, "RGB");
  addPlanes(bare, "", normal, "XYZ");
  addPlanes(left, "Layer.Combined", other, "RGB");
  writeParts(path, {{"Layer.Combined", blender}, {"normals", bare}, {"Layer.Combined-left", left, "left"}});
  const ExrHeader header = readExrHeader(path);
  CHECK(header.views == std::vector<std::string>{"left"});
  CHECK(header.channels == std::vector<std::string>{"Layer.Combined.B", "Layer.Combined.G",
                                                    "Layer.Combined.R", "normals.X", "normals.Y", "normals.Z",
                                                    "Layer.Combined.left.B", "Layer.Combined.left.G",
                                                    "Layer.Combined.left.R"});
  CHECK(samePixels(readExr(path), normal));  // the one set of bare names
  CHECK(samePixels(readExr(path, {"normals.X", "normals.Y", "normals.Z"}), normal));
  const Image mixed = readExr(path, {"Layer.Combined.left.G", "Layer.Combined.R"});
  CHECK(mixed.at(3, 2, 0) == other.at(3, 2, 1));
  CHECK(mixed.at(3, 2, 1) == color.at(3, 2, 0));
}

TEST_CASE("a file too short for the pixels that it claims is refused before memory is taken for them") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.exr");
  Planes planes;
  addPlanes(planes, "", noiseImage(4, 4, 1, 1), "Y");
  for (const PixelWindow& claimed : {PixelWindow{0, -1000000000, 1, 2000000000}, PixelWindow{0, 0, 1, 200000},
                                     PixelWindow{0, 0, 50331649, 3}}) {
    writePlanes(path, planes);
    std::string bytes = readFile(path);
    for (const char* window : {"dataWindow", "displayWindow"}) {
      const std::size_t value = bytes.find(window) + std::string(window).size() + sizeof("\0box2i") + 4;
      const int corners[] = {claimed.x, claimed.y, claimed.x + claimed.width - 1,
                             claimed.y + claimed.height - 1};
      bytes.replace(value, sizeof(corners), reinterpret_cast<const char*>(corners), sizeof(corners));
    }
    writeTextFile(path, bytes);
    CHECK_THROWS_MATCHES(readExrHeader(path), Error,
                         failsWith(ErrorCode::FileError, {"a.exr", "data window"}));
  }
}

TEST_CASE("a written picture keeps windows and attributes of the one that it was made from") {
  const TemporaryDirectory directory;
  const std::string from = directory.file("a.exr"), to = directory.file("b.exr");
  const PictureWindows windows{{16, 9, 5, 4}, {0, 0, 30, 20}};
  Planes planes;
  addPlanes(planes, "", noiseImage(5, 4, 3, 1), "RGB");
  Imf::Header header(boxOf(windows.display), boxOf(windows.data));
  Imf::addOwner(header, "the studio");
  header.insert("cryptomatte/1/name", Imf::StringAttribute("uCryptoObject"));
  writePlanes(from, planes, header);
  const ExrHeader read = readExrHeader(from);
  const Image image = noiseImage(5, 4, 3, 2);
  writeExr(to, image, {"R", "G", "B"}, ExrType::Float, {read.windows, read.attributes});
  const ExrHeader written = readExrHeader(to);
  CHECK(written.windows.data == windows.data);
  CHECK(written.windows.display == windows.display);
  CHECK(Imf::owner(*written.attributes) == "the studio");
  CHECK(written.attributes->find("cryptomatte/1/name") == written.attributes->end());
  CHECK(samePixels(readExr(to), image));
  // A picture of another size, such as a sheet of several, is one of its own.
  writeExr(to, noiseImage(6, 4, 3, 2), {"R", "G", "B"}, ExrType::Float, {read.windows, read.attributes});
  CHECK(readExrHeader(to).windows.data == PixelWindow{0, 0, 6, 4});
}

TEST_CASE("images are placed by window, and cameras follow") {
  const Image image = noiseImage(4, 3, 2, 1);
  const Image moved = placed(image, {2, 1, 4, 3}, {3, 0, 4, 3});
  CHECK(moved.at(0, 1, 1) == image.at(1, 0, 1));
  CHECK(moved.at(2, 2, 0) == image.at(3, 1, 0));
  for (const int x : {0, 3}) CHECK(moved.at(x, x == 0 ? 0 : 2, 0) == 0.0f);  // above and right of the image
  CHECK(intersection({0, 0, 2, 2}, {5, 0, 2, 2}).width == 0);

  Camera camera;
  camera.worldToClip = {1, 0, 0.5, 0, 0, 2, 0, 0.25, 0, 0, 1, 0, 0, 0, 1, 3};
  const PictureWindows windows{{16, 9, 96, 54}, {-2, 1, 120, 68}};
  const Camera part = cropped(camera, windows);
  const double point[] = {0.7, -0.4, 2.0, 1.0};
  const auto pixel = [&](const quell::Matrix4& m, const PixelWindow& window) {
    double clip[4] = {};
    for (std::size_t i = 0; i < 16; ++i) clip[i / 4] += m[i] * point[i % 4];
    return std::make_pair(window.x + window.width * (0.5 + 0.5 * clip[0] / clip[3]),
                          window.y + window.height * (0.5 - 0.5 * clip[1] / clip[3]));
  };
  const auto [x, y] = pixel(camera.worldToClip, windows.display);
  CHECK(pixel(part.worldToClip, windows.data).first == Approx(x));
  CHECK(pixel(part.worldToClip, windows.data).second == Approx(y));
}
