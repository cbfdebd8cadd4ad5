#include "host/io/camera_file.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/io/atomic_file.hpp"
#include "host/io/declared_cameras.hpp"
#include "host/io/look_at.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/multilayer_files.hpp"
#include "tests/support/temporary_directory.hpp"

using namespace quell::io;
using quell::Camera;
using quell::Error;
using quell::ErrorCode;
using quell::Matrix4;
using quell::tests::failsWith;
using quell::tests::TemporaryDirectory;
using namespace quell::tests::multilayer;
using nlohmann::json;

namespace {

constexpr double kAspect = double(kWidth) / kHeight;
constexpr PixelWindow kWhole{0, 0, kWidth, kHeight};
const json kOnes = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

struct File {
  TemporaryDirectory directory;
  std::string path = directory.file("camera.json");

  CameraFile read(const json& document) const {
    writeTextFile(path, document.dump());
    return readCameraFile(path, kAspect);
  }
};

json lookAtEntry() {
  return {{"frame", 0}, {"eye", {1, 2, 3}}, {"target", {1, 5, 3}}, {"up", {0, 0, 2}}, {"fov", 90}};
}

// Matrices of a frame, written down in one of the ways.
json written(const Camera& camera, const MatrixReading& reading) {
  return {{"frame", 0},
          {"view_projection",
           readAs({"", reading.transposed, false}, readAs({"", false, reading.yDown}, camera.worldToClip))},
          {"previous_view_projection", readAs({"", reading.transposed, false},
                                              readAs({"", false, reading.yDown}, camera.worldToClipPrev))}};
}

}  // namespace

TEST_CASE("a camera by eye, target and field of view", "[camera file]") {
  const File file;
  const Matrix4 m = file.read({{"frames", {lookAtEntry()}}}).cameras.at(0).worldToClip;
  const auto ndc = [&](std::array<double, 3> p) {
    const auto row = [&](std::size_t r) {
      return m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
    };
    CHECK(row(3) == Approx(p[1] - 2.0));  // view depth
    return std::array<double, 2>{row(0) / row(3), row(1) / row(3)};
  };
  CHECK(ndc({1, 4, 3})[0] == Approx(0.0).margin(1e-12));
  CHECK(ndc({1, 4, 5})[1] == Approx(1.0));  // 45 degrees up
  CHECK(ndc({3, 4, 3})[0] == Approx(1.0 / kAspect));
  json wide = lookAtEntry();
  wide["fov_axis"] = "larger";
  wide["aspect"] = 2.0;
  const Matrix4 x = file.read({{"frames", {wide}}}).cameras.at(0).worldToClip;
  CHECK(x[0] == Approx(1.0));
  CHECK(x[6] == Approx(2.0));
}

TEST_CASE("what is the same for all frames stands once, and the frame before is the one before",
          "[camera file]") {
  const File file;
  json first = {{"frame", -1}, {"view", kOnes}}, second = {{"frame", 0}, {"view", kOnes}};
  second["view"][3] = 5;
  const CameraFile read =
      file.read({{"frames", {second, first}}, {"projection", kOnes}, {"near", 0.1}, {"far", 7}});
  CHECK(read.cameras.at(0).worldToClip[3] == 5.0);
  CHECK(read.cameras.at(0).worldToClipPrev[3] == 0.0);
  CHECK(read.cameras.at(-1).worldToClipPrev == read.cameras.at(-1).worldToClip);
  CHECK(read.ranges.at(0).near == 0.1);
  CHECK(read.ranges.at(0).far == 7.0);
  CHECK_FALSE(read.declared);
}

TEST_CASE("messages name the entry of camera.json", "[camera file]") {
  const File file;
  const auto refusal = [&](const json& document, std::vector<std::string> words) {
    words.push_back("camera.json");
    INFO(document.dump());
    REQUIRE_THROWS_MATCHES(file.read(document), Error, failsWith(ErrorCode::FileError, words));
  };
  const auto entryRefusal = [&](const char* key, const json& value, const std::vector<std::string>& words) {
    json entry = lookAtEntry();
    entry[key] = value;
    refusal({{"frames", {entry}}}, words);
  };
  refusal(json::array(), {"frames: a list of frames", "got none"});
  refusal({{"frames", 7}}, {"frames: a list", "got 7"});
  refusal({{"frames", {7}}}, {"frames[0].frame"});
  refusal({{"frames", {{{"frame", 1}}}}}, {"frames[0]", "view_projection", "eye"});
  refusal({{"frames", {lookAtEntry(), lookAtEntry()}}}, {"frames[1].frame", "no other entry", "got 0"});
  refusal({{"frames", {{{"frame", 1}, {"view", kOnes}}}}}, {"frames[0].projection"});
  refusal({{"frames", json::array()}, {"vectors", "rows"}}, {"vectors", "\"column\" or \"row\"", "\"rows\""});
  refusal({{"frames", json::array()}, {"ndc_y", 1}}, {"ndc_y", "\"up\" or \"down\""});
  entryRefusal("frame", 1.5, {"frames[0].frame", "whole number", "1.5"});
  entryRefusal("frame", 1e300, {"frames[0].frame", "whole number"});
  entryRefusal("eye", {1, 2}, {"frames[0].eye", "3 numbers", "[1,2]"});
  entryRefusal("eye", {1, 2, "3"}, {"frames[0].eye[2]", "a number", "\"3\""});
  entryRefusal("target", {1, 2, 3}, {"frames[0]", "apart"});
  entryRefusal("up", {0, -1, 0}, {"frames[0]", "not along"});
  entryRefusal("fov", 180, {"frames[0].fov", "below 180"});
  entryRefusal("fov", -3, {"frames[0].fov", "above 0"});
  entryRefusal("fov_axis", "z", {"frames[0].fov_axis", "\"smaller\""});
  entryRefusal("aspect", 0, {"frames[0].aspect"});
  entryRefusal("near", 0, {"frames[0].near", "above 0"});
  entryRefusal("far", 1, {"frames[0].near", "none"});
  entryRefusal("view_projection", {{1, 2, 3, 4}, {1, 2, 3, nullptr}, {1, 2, 3, 4}, {1, 2, 3, 4}},
               {"frames[0].view_projection[1][3]", "null"});
}

TEST_CASE("matrices are read as positions show that they are meant", "[camera file]") {
  const File file;
  const FrameData original = builtIn()->read(3);
  for (const MatrixReading& reading : matrixReadings()) {
    INFO(reading.name);
    json document = {{"frames", {written(original.camera, reading)}}};
    const auto cameraOf = [&] {
      writeTextFile(file.path, document.dump());
      const DeclaredCameras cameras(file.path, {kWhole, kWhole}, {0});
      FrameData frame;
      cameras.setCamera(frame, [&] { return original.positionWorld; });
      return frame;
    };
    const FrameData found = cameraOf();
    CHECK(found.camera.worldToClip == original.camera.worldToClip);
    CHECK(found.camera.worldToClipPrev == original.camera.worldToClipPrev);
    CHECK(found.warnings.size() == (reading.transposed || reading.yDown ? 1 : 0));
    document["vectors"] = reading.transposed ? "row" : "column";
    document["ndc_y"] = reading.yDown ? "down" : "up";
    const FrameData told = cameraOf();
    CHECK(told.camera.worldToClip == original.camera.worldToClip);
    CHECK(told.warnings.empty());
  }
  // Where none fits, matrices are taken as they stand.
  writeTextFile(file.path, json{{"frames", {{{"frame", 0}, {"view_projection", kOnes}}}}}.dump());
  FrameData frame;
  DeclaredCameras(file.path, {kWhole, kWhole}, {0}).setCamera(frame, [&] { return original.positionWorld; });
  CHECK(frame.camera.worldToClip[0] == 1.0);
  CHECK(frame.warnings.empty());
}
