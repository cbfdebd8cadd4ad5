// quell demo: frames, page and report, and the same pictures as rendering to files and denoising those.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/cli/demo/page.hpp"
#include "host/cli/run_tool.hpp"
#include "host/io/atomic_file.hpp"
#include "host/io/base64.hpp"
#include "host/io/png_image.hpp"
#include "tests/support/temporary_directory.hpp"

namespace quell::tests {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 36;

int quell(std::vector<std::string> arguments) {
  std::vector<const char*> argv = {"quell"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return cli::runTool(static_cast<int>(argv.size()), argv.data());
}

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

struct Difference {
  double mean = 0.0;
  double largest = 0.0;
};

/// Of the second pane of a comparison sheet and a picture, in steps of 8 bits.
Difference differenceOfDenoised(const io::Image& sheet, const io::Image& picture) {
  Difference difference;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) {
        const double steps = 255.0 * std::abs(sheet.at(kWidth + x, y, c) - picture.at(x, y, c));
        difference.mean += steps / (3.0 * kWidth * kHeight);
        difference.largest = std::max(difference.largest, steps);
      }
  return difference;
}

}  // namespace

TEST_CASE("demo leaves frames, a page that needs nothing else, and a report", "[render]") {
  const TemporaryDirectory directory;
  const std::string out = directory.path() + "/out", json = directory.path() + "/report.json";
  REQUIRE(quell({"demo", "--scene", "cornell", "--size", "64x36", "--frames", "2", "--reference", "2",
                 "--output", out, "--json", json}) == 0);
  const std::string first = out + "/comparison_0000.png", last = out + "/comparison_0001.png";
  CHECK(io::readPng(first).width == 2 * kWidth);
  CHECK(io::readPng(last).width == 3 * kWidth);
  CHECK(io::readPng(last).height == kHeight);

  std::string page = io::readFile(out + "/index.html");
  for (const std::string& frame : {first, last}) {
    const std::string uri = "\"data:image/png;base64," + io::base64(io::readFile(frame)) + "\"";
    REQUIRE(page.find(uri) != std::string::npos);
    page.erase(page.find(uri), uri.size());
  }
  for (const char* text : {"shade", "accumulate_noisy", "frame 1 denoised", "noisy, 1 sample per pixel",
                           "reference, 4 samples per pixel"})
    CHECK(page.find(text) != std::string::npos);
  // Nothing from elsewhere: no address, no file, no request.
  for (const char* text : {"http:", "https:", "src=", "href=", "<link", "<iframe", "@import", "url(",
                           "import(", "fetch(", "XMLHttpRequest", "DEMO_DATA"}) {
    INFO(text);
    CHECK(page.find(text) == std::string::npos);
  }

  const auto report = nlohmann::json::parse(io::readFile(json));
  CHECK(report.at("scene") == "cornell");
  CHECK(report.at("frames") == 2);
  CHECK(report.at("errors").size() == 1);
  CHECK(report.at("errors").at(0).at("frame") == 1);
  REQUIRE(report.at("tracing").at("stages").size() == 3);
  for (const auto& stage : report.at("tracing").at("stages"))
    CHECK(stage.at("median_ms").get<double>() > 0.0);
  CHECK(report.at("frame_ms").at("median").get<double>() > 0.0);
}

TEST_CASE("demo gives the pictures of rendering to files and denoising those", "[render]") {
  const TemporaryDirectory directory;
  const std::string files = directory.path() + "/files";
  const std::vector<std::string> sequence = {"--scene", "roughness", "--size", "64x36", "--frames", "2"};
  REQUIRE(quell(with({"render", "--output", files}, sequence)) == 0);
  const std::vector<std::vector<std::string>> methods = {
      {"--method", "bmfr"}, {"--method", "atrous", "--signals", "2", "--demodulate", "albedo"}};
  for (const std::vector<std::string>& method : methods) {
    const std::string demo = directory.path() + "/demo", denoised = directory.path() + "/denoised";
    REQUIRE(quell(with(with({"demo", "--reference", "0", "--output", demo}, sequence), method)) == 0);
    REQUIRE(quell(with({"denoise", "--input", files, "--output", denoised}, method)) == 0);
    const Difference difference = differenceOfDenoised(io::readPng(demo + "/comparison_0001.png"),
                                                       io::readPng(denoised + "/display_0001.png"));
    INFO(method[1] << ": mean " << difference.mean << ", largest " << difference.largest);
    // Files hold halves, and a rounded step of 8 bits may go either way.
    CHECK(difference.mean < 0.05);
    CHECK(difference.largest < 3.0);
  }
}

TEST_CASE("demo refuses what it cannot do", "[render]") {
  const TemporaryDirectory directory;
  const auto demo = [&](std::vector<std::string> arguments) {
    return quell(with({"demo", "--output", directory.path() + "/out", "--frames", "1"}, arguments));
  };
  CHECK(quell({"demo"}) != 0);
  CHECK(demo({"--scene", "nowhere"}) != 0);
  CHECK(demo({"--method", "magic"}) != 0);
  CHECK(demo({"--size", "0x5"}) == 1);
  CHECK(demo({"--set", "nothing=1"}) == 1);
  CHECK(demo({"--frames", "0"}) != 0);
  CHECK(quell({"demo", "--output", "/dev/null/out", "--frames", "1", "--size", "8x8"}) == 1);
}

TEST_CASE("a page holds as many sheets as fit, evenly spread, the last always", "[render]") {
  std::vector<cli::DemoSheet> sheets;
  for (int number = 0; number < 10; ++number) sheets.push_back({number, 2, "", 100});
  const auto numbers = [&](std::size_t mostBytes) {
    std::vector<int> result;
    for (const cli::DemoSheet& sheet : cli::sheetsWithin(sheets, mostBytes)) result.push_back(sheet.number);
    return result;
  };
  CHECK(numbers(1000) == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(numbers(999) == std::vector<int>{1, 3, 5, 7, 9});
  CHECK(numbers(400) == std::vector<int>{0, 3, 6, 9});
  CHECK(numbers(1) == std::vector<int>{9});
}

}  // namespace quell::tests
