// quell compare: what it takes for encoded, which keys its JSON has, and how it refuses.
#include <CLI/App.hpp>
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/cli/common/commands.hpp"
#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/png_image.hpp"
#include "host/metrics/display_encoding.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using quell::Error;
using quell::ErrorCode;
using quell::tests::failsWith;
using quell::tests::noiseImage;
using quell::tests::TemporaryDirectory;
namespace io = quell::io;

namespace {

constexpr int kWidth = 20, kHeight = 14;

/// Files a.exr and b.exr (halves), linear.exr, display_0001.exr and picture.png (a as it is shown).
struct Files {
  TemporaryDirectory directory;

  Files() {
    const io::Image a = noiseImage(kWidth, kHeight, 3, 1), b = noiseImage(kWidth, kHeight, 3, 2);
    const io::Image shown = quell::metrics::encodeForDisplay(a);
    io::writeExr(path("a.exr"), a, io::ExrType::Float);
    io::writeExr(path("b.exr"), b, io::ExrType::Float);
    io::writeExr(path("linear.exr"), noiseImage(kWidth, kHeight, 3, 3), io::ExrType::Float);
    io::writeExr(path("display_0001.exr"), shown, io::ExrType::Float);
    io::writePng(path("picture.png"), shown);
  }

  std::string path(const std::string& name) const { return directory.file(name); }
};

void runCompare(std::vector<std::string> arguments) {
  CLI::App app;
  quell::cli::addCompareCommand(app);
  arguments.insert(arguments.begin(), "compare");
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
  app.parse(arguments);
}

}  // namespace

TEST_CASE("quell compare writes its figures under stable keys") {
  const Files files;
  runCompare({"--reference", files.path("a.exr") + "," + files.path("b.exr"), files.path("linear.exr"),
              files.path("display_0001.exr"), "--json", files.path("out.json")});
  const auto report = nlohmann::json::parse(io::readFile(files.path("out.json")));
  REQUIRE(report.at("images").size() == 2);
  REQUIRE(report.at("temporal_error").get<double>() > 0.0);
  const nlohmann::json& linear = report.at("images").at(0);
  REQUIRE(linear.at("image") == files.path("linear.exr"));
  for (const char* key : {"rmse", "unbiased_rmse", "psnr", "ssim", "flip", "relmse"})
    REQUIRE(linear.at(key).is_number());
  REQUIRE(report.at("images").at(1).at("relmse").is_null());
}

TEST_CASE("quell compare takes PNG and display_ files as encoded") {
  const Files files;
  runCompare({"--reference", files.path("a.exr"), files.path("display_0001.exr"), files.path("picture.png"),
              files.path("a.exr"), "--json", files.path("out.json")});
  const auto images = nlohmann::json::parse(io::readFile(files.path("out.json"))).at("images");
  constexpr double kHalfAByte = 0.5 / 255.0;
  REQUIRE(images.at(0).at("rmse") == 0.0);
  REQUIRE(images.at(1).at("rmse") < kHalfAByte);
  REQUIRE(images.at(2).at("relmse") == 0.0);
  REQUIRE(images.at(2).at("psnr").is_null());  // infinite
  REQUIRE(images.at(2).at("unbiased_rmse").is_null());
}

TEST_CASE("quell compare writes one heat map per image, also where names repeat") {
  const Files files;
  runCompare({"--reference", files.path("a.exr"), files.path("linear.exr"), files.path("linear.exr"),
              "--heatmap", files.path("maps")});
  for (const char* name : {"maps/flip_linear.png", "maps/flip_linear_2.png"}) {
    const io::Image map = io::readPng(files.path(name));
    REQUIRE(map.width == kWidth);
    REQUIRE(map.height == kHeight);
  }
}

TEST_CASE("quell compare names the file that does not fit") {
  const Files files;
  const std::string small = files.path("small.exr");
  io::writeExr(small, io::Image(kWidth, kHeight - 1, 3));
  REQUIRE_THROWS_MATCHES(runCompare({"--reference", files.path("a.exr"), small}), Error,
                         failsWith(ErrorCode::InvalidArgument, {"small.exr", "20x14", "20x13"}));
  REQUIRE_THROWS_MATCHES(runCompare({"--reference", files.path("a.exr") + "," + small, files.path("a.exr")}),
                         Error, failsWith(ErrorCode::InvalidArgument, {"small.exr", "20x14", "20x13"}));
  REQUIRE_THROWS_MATCHES(runCompare({"--reference", files.path("picture.png"), files.path("a.exr")}), Error,
                         failsWith(ErrorCode::InvalidArgument, {"--reference", "picture.png"}));
  REQUIRE_THROWS_MATCHES(runCompare({"--reference", files.path("a.exr"), files.path("none.exr")}), Error,
                         failsWith(ErrorCode::FileError, {"none.exr"}));
  REQUIRE_THROWS_MATCHES(runCompare({"--reference", files.path("a.exr"), files.path("b.exr"), "--json",
                                     files.path("none/out.json")}),
                         Error, failsWith(ErrorCode::FileError, {"none/out.json"}));
}
