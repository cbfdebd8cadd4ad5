// quell check as a command, and what denoise says of what it finds.
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "host/io/exr_image.hpp"
#include "host/io/png_image.hpp"
#include "tests/check/plane_frames.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

nlohmann::json toJson(const Matrix4& m) {
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t r = 0; r < 4; ++r) rows.push_back({m[4 * r], m[4 * r + 1], m[4 * r + 2], m[4 * r + 3]});
  return rows;
}

// Frames 0 to 2 as data/README.md says, after a change.
void writePlane(const std::string& directory, void (*change)(io::FrameData&)) {
  nlohmann::json cameras = {{"frames", nlohmann::json::array()}};
  std::filesystem::create_directories(directory);
  for (int number = 0; number < 3; ++number) {
    io::FrameData frame = planeFrame(number);
    change(frame);
    for (const auto& facts : kInputs<io::FrameData>) {
      const io::Image& image = frame.*facts.member;
      if (image.empty()) continue;
      io::writeExr(directory + "/" + facts.files.stem + "_000" + std::to_string(number) + ".exr", image,
                   io::ExrType::Float);
    }
    cameras["frames"].push_back({{"frame", number},
                                 {"view_projection", toJson(frame.camera.worldToClip)},
                                 {"previous_view_projection", toJson(frame.camera.worldToClipPrev)}});
  }
  io::writeTextFile(directory + "/camera.json", cameras.dump());
}

}  // namespace

TEST_CASE("a sequence in order is fine, with figures as JSON", "[cli]") {
  const TemporaryDirectory directory;
  const std::string json = directory.file("check.json");
  CHECK(quell({"check", kData, "--frame-count", "2", "--json", json}) == 0);
  const nlohmann::json report = readJson(json);
  CHECK(report["verdict"] == "fine");
  CHECK(report["frames"] == nlohmann::json({4, 5}));
  CHECK(report["figures"][0]["name"] == "surface share");
  CHECK(report["figures"][0]["mean"].get<double>() == Approx(94.8).margin(0.2));
}

TEST_CASE("doubtful and wrong frames have exit codes of their own, findings and pictures", "[cli]") {
  const TemporaryDirectory directory;
  const std::string frames = directory.file("frames"), json = directory.file("check.json");
  writePlane(frames, [](io::FrameData& frame) {
    for (float& value : frame.positionWorld.pixels) value *= 4.0f;
  });
  CHECK(quell({"check", frames, "--json", json, "--pictures", directory.file("pictures"), "--html",
               directory.file("check.html")}) == 2);
  const nlohmann::json finding = readJson(json)["findings"][0];
  CHECK(finding["kind"] == "position-sum");
  CHECK(finding["severity"] == "wrong");
  CHECK(finding["frames"] == nlohmann::json({0, 1, 2}));
  CHECK(finding["pixels"].get<int>() > kPlaneWidth * kPlaneHeight / 2);
  CHECK(io::readPng(directory.file("pictures/position-sum_0001.png")).width == 2 * kPlaneWidth);
  CHECK_THAT(io::readFile(directory.file("check.html")),
             Catch::Contains("position-sum") && Catch::Contains("data:image/png;base64,"));
  // Read as meant, but said.
  const std::string columns = directory.file("columns");
  writePlane(columns, [](io::FrameData& frame) {
    transpose(frame.camera.worldToClip);
    transpose(frame.camera.worldToClipPrev);
  });
  CHECK(quell({"check", columns, "--json", json}) == 1);
  CHECK(readJson(json)["findings"][0]["kind"] == "camera-convention");
  writePlane(directory.file("doubtful"), [](io::FrameData& frame) {
    for (float& value : frame.albedo.pixels) value = 0.0f;
  });
  CHECK(quell({"check", directory.file("doubtful")}) == 1);
}

TEST_CASE("what cannot be read is wrong, and said", "[cli]") {
  const TemporaryDirectory directory;
  const std::string text = errorStreamOf({"check", directory.file("nothing")}, 2, directory.file("stderr"));
  CHECK_THAT(text, Catch::Contains("nothing"));
  CHECK_THAT(errorStreamOf({"check", kData, "--frames", "90-91"}, 2, directory.file("stderr")),
             Catch::Contains("--frames"));
}

TEST_CASE("denoise says once what checks find in the first frames", "[cli]") {
  const TemporaryDirectory directory;
  const std::string frames = directory.file("frames");
  writePlane(frames, [](io::FrameData& frame) {
    for (float& value : frame.normalWorld.pixels) value = 0.5f * value + 0.5f;
  });
  const std::string text =
      errorStreamOf({"denoise", "--input", frames, "--timers", "off"}, 0, directory.file("stderr"));
  const auto at = text.find("quell: warning: ");
  REQUIRE(at != std::string::npos);
  CHECK_THAT(text, Catch::Contains("shading_normal_0000.exr") && Catch::Contains("2 n - 1"));
  CHECK(text.find("quell: warning: ", at + 1) == std::string::npos);
}

}  // namespace quell::tests
