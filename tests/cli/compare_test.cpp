// What `quell compare` says of odd pictures, and the formats that it reads.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>

#include "host/io/exr_image.hpp"
#include "host/io/plain_image.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

using Catch::Contains;

constexpr int kWidth = 20, kHeight = 14;

struct Pictures {
  TemporaryDirectory directory;
  io::Image picture = noiseImage(kWidth, kHeight, 3, 1);

  std::string write(const std::string& name, const io::Image& image) const {
    io::writeExr(directory.file(name), image, io::ExrType::Float);
    return directory.file(name);
  }
  // Rows and columns of the picture as a file whose data window is that part of the whole.
  std::string crop(const std::string& name, const io::PixelWindow& window) const {
    const io::PixelWindow whole{0, 0, kWidth, kHeight};
    io::writeExr(directory.file(name), io::placed(picture, whole, window), {"R", "G", "B"},
                 io::ExrType::Float, {{window, whole}, nullptr});
    return directory.file(name);
  }
  // The error stream, and the figures of the image.
  std::string compare(const std::string& reference, const std::string& image, int code = 0) {
    const std::string text =
        errorStreamOf({"compare", "--reference", reference, image, "--json", directory.file("json")}, code,
                      directory.file("stderr"));
    figures = code == 0 ? readJson(directory.file("json")).at("images").at(0) : nlohmann::json();
    return text;
  }
  nlohmann::json figures;
};

}  // namespace

TEST_CASE("pixels that are not finite are counted by file, and give no figures", "[compare]") {
  Pictures p;
  const std::string good = p.write("good.exr", p.picture);
  io::Image broken = p.picture;
  broken.at(3, 4, 1) = std::numeric_limits<float>::quiet_NaN();
  broken.at(5, 4, 0) = std::numeric_limits<float>::infinity();
  const std::string bad = p.write("bad.exr", broken);
  CHECK_THAT(p.compare(good, bad), Contains("bad.exr") && Contains("1 that are not numbers") &&
                                       Contains("1 infinite") && !Contains("good.exr"));
  CHECK(p.figures.at("non_finite_pixels") == 2);
  CHECK(p.figures.at("rmse").is_null());
  CHECK_THAT(p.compare(bad, good), Contains("bad.exr"));
  CHECK(p.figures.at("non_finite_pixels") == 0);
  CHECK(p.figures.at("flip").is_null());
  CHECK(p.compare(good, good).empty());
  CHECK(p.figures.at("rmse") == 0.0);
}

TEST_CASE("halves of a reference that are one and the same are told", "[compare]") {
  Pictures p;
  const std::string a = p.write("a.exr", p.picture), b = p.write("b.exr", p.picture);
  CHECK_THAT(p.compare(a + "," + b, a),
             Contains("b.exr") && Contains("the same pixels") && Contains("seeds"));
  p.write("b.exr", noiseImage(kWidth, kHeight, 3, 2));
  CHECK(p.compare(a + "," + b, a).empty());
}

TEST_CASE("commas in names of files are no separators where the file exists", "[compare]") {
  Pictures p;
  const std::string one = p.write("a,b.exr", p.picture),
                    two = p.write("c,d.exr", noiseImage(kWidth, kHeight, 3, 2));
  p.compare(one, one);
  CHECK(p.figures.at("rmse") == 0.0);
  CHECK(p.figures.at("unbiased_rmse").is_null());
  p.compare(one + "," + two, one);
  CHECK(p.figures.at("unbiased_rmse").is_number());
  CHECK_THAT(p.compare(one + ",none.exr", one, 1), Contains("no such file"));
}

TEST_CASE("pictures are compared where all have pixels", "[compare]") {
  Pictures p;
  const std::string whole = p.write("whole.exr", p.picture);
  const std::string left = p.crop("left.exr", {0, 0, 15, kHeight}),
                    right = p.crop("right.exr", {4, 2, kWidth - 4, kHeight - 2});
  for (const auto& [reference, image] : {std::pair{whole, left}, {left, whole}, {left, right}}) {
    p.compare(reference, image);
    CHECK(p.figures.at("rmse") == 0.0);
  }
  // Who knows no windows writes the pixels of a crop as a picture of their own.
  p.compare(left, p.write("plain.exr", io::placed(p.picture, {0, 0, kWidth, kHeight}, {0, 0, 15, kHeight})));
  CHECK(p.figures.at("rmse") == 0.0);
  CHECK_THAT(p.compare(whole, p.write("small.exr", noiseImage(9, 9, 3, 1)), 1),
             Contains("small.exr") && Contains("20x14") && Contains("9x9"));
  CHECK_THAT(p.compare(p.crop("top.exr", {0, 0, 5, 5}), p.crop("bottom.exr", {9, 9, 5, 5}), 1),
             Contains("bottom.exr") && Contains("5x5"));
  // Too small for a window of SSIM.
  p.compare(whole, p.crop("strip.exr", {0, 0, kWidth, 5}));
  CHECK(p.figures.at("ssim").is_null());
  CHECK(p.figures.at("flip").is_number());
}

TEST_CASE("PFM and raw samples are compared", "[compare]") {
  Pictures p;
  const std::string reference = p.write("reference.exr", p.picture);
  const std::string pfm = p.directory.file("image.pfm"), raw = p.directory.file("image.raw");
  io::writePfm(pfm, p.picture);
  const auto writeRaw = [&](std::size_t bytes) {
    std::ofstream(raw, std::ios::binary)
        .write(reinterpret_cast<const char*>(p.picture.pixels.data()), std::streamsize(bytes));
  };
  writeRaw(p.picture.pixels.size() * sizeof(float));
  for (const auto& [a, b] : {std::pair{reference, pfm}, {reference, raw}, {pfm, raw}}) {
    p.compare(a, b);
    CHECK(p.figures.at("rmse") == 0.0);
  }
  CHECK_THAT(p.compare(raw, pfm, 1), Contains("image.raw") && Contains("--size"));
  CHECK(quell({"compare", "--reference", raw, "--size", "20x14", pfm}) == 0);
  writeRaw(100);
  CHECK_THAT(p.compare(reference, raw, 1), Contains("image.raw") && Contains("got 100 bytes"));
}

}  // namespace quell::tests
