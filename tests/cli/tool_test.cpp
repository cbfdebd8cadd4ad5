// The quell tool as a user runs it: files, reports and messages.
#include "tests/support/tool.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/png_image.hpp"
#include "tests/support/temporary_directory.hpp"

namespace quell::tests {
namespace {

namespace fs = std::filesystem;

// Two frames of data/colonnade with light of two kinds added.
void writeTwoSignals(const std::string& directory) {
  fs::copy(kData + "/camera.json", directory);
  for (const char* frame : {"_0014.exr", "_0015.exr"}) {
    for (const char* buffer : {"color", "shading_normal", "world_position", "albedo", "emission"})
      fs::copy(kData + "/" + buffer + frame, directory);
    const io::Image light = io::readExrRgb(kData + "/color" + frame);
    io::writeExr(directory + "/diffuse_irradiance" + frame, light, io::ExrType::Half);
    io::writeExr(directory + "/glossy_radiance" + frame, light, io::ExrType::Half);
  }
}

// What a command that fails prints to the error stream, by way of this file.
std::string complaintOf(const std::vector<std::string>& arguments, const std::string& file) {
  return errorStreamOf(arguments, 1, file);
}

}  // namespace

TEST_CASE("denoise writes frames, pictures and a report", "[cli]") {
  const TemporaryDirectory directory;
  const std::string out = directory.path() + "/out";
  const std::string json = directory.path() + "/report.json";
  REQUIRE(quell({"denoise", "--method", "bmfr", "--input", kData, "--output", out, "--frames", "13-15",
                 "--png", "--exr", "--json", json}) == 0);
  for (const char* frame : {"0013", "0014", "0015"}) {
    const io::Image linear = io::readExr(out + "/denoised_" + frame + ".exr");
    CHECK(linear.width == 240);
    CHECK(linear.height == 135);
    CHECK(io::readPng(out + "/display_" + frame + ".png").width == 240);
    CHECK(io::readExr(out + "/display_" + frame + ".exr").width == 240);
  }
  CHECK(io::readPng(out + "/comparison_0015.png").width == 3 * 240);

  const auto report = readJson(json);
  CHECK(report.at("method") == "bmfr");
  CHECK(report.at("width") == 240);
  CHECK(report.at("height") == 135);
  CHECK(report.at("frames") == 3);
  CHECK(report.at("memory_bytes").get<double>() > 0.0);
  CHECK(report.at("output_hash").get<std::string>().size() == 16);
  CHECK(report.at("settings").at("noisyLeastWeight") == 0.2);
  CHECK(report.at("frame_ms").at("median").get<double>() > 0.0);
  REQUIRE(report.at("stages").size() == 8);
  for (const auto& stage : report.at("stages")) {
    CHECK(stage.at("median_ms").get<double>() >= stage.at("min_ms").get<double>());
    CHECK(stage.at("max_ms").get<double>() >= stage.at("median_ms").get<double>());
    CHECK(stage.at("bytes").get<double>() > 0.0);
  }
  CHECK(report.at("errors").at(0).at("frame") == 15);
  CHECK(report.at("errors").at(0).at("linear_reference") == "centre");
  CHECK(report.at("errors").at(0).at("display_reference") == "centre");
}

TEST_CASE("denoise dumps intermediate buffers", "[cli]") {
  const TemporaryDirectory directory;
  const std::string out = directory.file("out"), json = directory.file("report.json");
  const auto hashOf = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"denoise", "--method", "bmfr", "--size", "40x30", "--frame-count", "2",
                               "--json", json, "--output", out});
    REQUIRE(quell(more) == 0);
    return readJson(json).at("output_hash");
  };
  const auto plain = hashOf({});
  CHECK(hashOf({"--dump", "beforeAntialiasing,historyLength,guides", "--dump", "fitRecords", "--exr"}) ==
        plain);
  const io::Image dumped = io::readExr(out + "/beforeAntialiasing_0000.exr");
  CHECK(dumped.width == 40);
  CHECK(dumped.height == 30);
  // It is the linear output, which is stored as half.
  const io::Image linear = io::readExr(out + "/denoised_0000.exr");
  for (std::size_t i = 0; i < linear.pixels.size(); ++i)
    REQUIRE(dumped.pixels[i] == Approx(linear.pixels[i]).epsilon(1.0 / 2048.0).margin(1e-7));
  const io::Image length = io::readExr(out + "/historyLength_0001.exr");
  CHECK(length.channels == 1);
  CHECK(*std::max_element(length.pixels.begin(), length.pixels.end()) == 2.0f);  // of two frames
  CHECK(io::readExr(out + "/guides_0001.exr", {"plane0", "plane1", "plane3"}).width == 40);
  const io::Image records = io::readExr(out + "/fitRecords_0001.exr");
  CHECK(records.height == 1);
  CHECK(records.width > 40);
}

TEST_CASE("buffers are dumped whole or not at all, and only those that there are", "[cli]") {
  const TemporaryDirectory directory;
  const std::string out = directory.file("out"), text = directory.file("stderr");
  const auto denoise = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"denoise", "--size", "40x30", "--frame-count", "2"});
    return more;
  };
  using Catch::Contains;
  CHECK_THAT(complaintOf(denoise({"--dump", "beforeAntialiasing"}), text), Contains("--output"));
  CHECK_THAT(complaintOf(denoise({"--dump", "beforeAntialiasing,nothing", "--output", out}), text),
             Contains("keptBuffers") && Contains("nothing") && Contains("antialiased"));
  CHECK(fs::is_empty(out));
  CHECK(quell(denoise({"--dump", "list"})) == 0);

  fs::create_directory(out + "/beforeAntialiasing_0001.exr");
  fs::create_directory(out + "/beforeAntialiasing_0001.exr/in_the_way");
  CHECK_THAT(complaintOf(denoise({"--dump", "beforeAntialiasing", "--output", out}), text),
             Contains("beforeAntialiasing_0001.exr"));
  CHECK(io::readExr(out + "/beforeAntialiasing_0000.exr").width == 40);
  CHECK(fs::exists(out + "/beforeAntialiasing_0001.exr/in_the_way"));
  for (const auto& entry : fs::directory_iterator(out))
    CHECK_THAT(entry.path().extension().string(), Catch::Equals(".exr") || Catch::Equals(".png"));
}

TEST_CASE("compare reads what denoise wrote", "[cli]") {
  const TemporaryDirectory directory;
  const std::string out = directory.path() + "/out";
  REQUIRE(quell({"denoise", "--input", kData, "--output", out, "--frames", "14-15"}) == 0);
  const std::string json = directory.path() + "/compare.json";
  REQUIRE(quell({"compare", "--reference", kData + "/ref_a_color_0015.exr," + kData + "/ref_b_color_0015.exr",
                 out + "/denoised_0015.exr", out + "/display_0015.png", "--json", json, "--heatmap",
                 directory.path() + "/heat"}) == 0);
  const auto report = readJson(json);
  CHECK(report.dump().find("unbiased_rmse") != std::string::npos);
  CHECK_FALSE(fs::is_empty(directory.path() + "/heat"));
}

TEST_CASE("a tool's mistakes are answered, not crashed on", "[cli]") {
  const TemporaryDirectory directory;
  CHECK(quell({}) != 0);
  CHECK(quell({"denoise", "--method", "magic"}) != 0);
  CHECK(quell({"denoise", "--input", directory.path() + "/none"}) == 1);
  CHECK(quell({"denoise", "--input", kData, "--frames", "3-15"}) == 1);
  CHECK(quell({"denoise", "--input", kData, "--frames", "15-14"}) == 1);
  CHECK(quell({"denoise", "--input", kData, "--frames", "a-b"}) == 1);
  CHECK(quell({"denoise", "--size", "0x10"}) == 1);
  CHECK(quell({"denoise", "--size", "banana"}) == 1);
  CHECK(quell({"denoise", "--size", "8x8", "--set", "nothing=1"}) == 1);
  CHECK(quell({"denoise", "--size", "8x8", "--set", "taaNewestWeight=7"}) == 1);
  CHECK(quell({"denoise", "--size", "8x8", "--set", "taaNewestWeight"}) == 1);
  CHECK(quell({"denoise", "--size", "8x8", "--device", "no such device"}) == 1);
  CHECK(quell({"denoise", "--size", "8x8", "--signals", "2"}) == 1);
}

TEST_CASE("denoise takes two signals where the sequence has them", "[cli]") {
  const TemporaryDirectory directory;
  const std::string input = directory.path(), json = directory.path() + "/report.json";
  writeTwoSignals(input);
  for (const char* method : {"bmfr", "svgf", "edagi", "guided", "atrous"}) {
    const auto hashOf = [&](const char* signals) {
      REQUIRE(quell({"denoise", "--method", method, "--input", input, "--signals", signals, "--output",
                     directory.path() + "/out", "--json", json}) == 0);
      const auto report = readJson(json);
      CHECK(report.at("frames") == 2);
      return report.at("output_hash").get<std::string>();
    };
    CHECK(hashOf("2") != hashOf("1"));
  }
  CHECK(quell({"bench", "--input", input, "--methods", "svgf", "--signals", "2", "--repeat", "1"}) == 0);
}

TEST_CASE("two signals are refused where there is one, saying why", "[cli]") {
  const TemporaryDirectory directory;
  const std::string text = directory.path() + "/stderr";
  using Catch::Contains;
  for (const char* command : {"denoise", "bench"}) {
    CHECK_THAT(complaintOf({command, "--size", "40x30", "--signals", "2"}, text),
               Contains("--signals") && Contains("built-in sequence"));
    CHECK_THAT(complaintOf({command, "--input", kData, "--signals", "2"}, text),
               Contains("diffuse_irradiance_0004.exr"));
    io::writeTextFile(directory.path() + "/camera_matrices.h", "");
    CHECK_THAT(complaintOf({command, "--input", directory.path(), "--signals", "2"}, text),
               Contains("two signals") && Contains("camera_matrices.h, which has one"));
  }
}

TEST_CASE("denoise starts from presets and leaves light undivided on demand", "[cli]") {
  const TemporaryDirectory directory;
  const std::string json = directory.path() + "/report.json";
  const auto settingsOf = [&](std::vector<std::string> more) {
    more.insert(more.begin(),
                {"denoise", "--method", "svgf", "--size", "40x30", "--frame-count", "2", "--json", json});
    REQUIRE(quell(std::move(more)) == 0);
    return readJson(json).at("settings");
  };
  CHECK(settingsOf({}).at("demodulate") == "albedo");
  const auto chosen = settingsOf({"--preset", "paper", "--demodulate", "none", "--set", "iterations=3"});
  CHECK(chosen.at("demodulate") == "none");
  CHECK(chosen.at("luminanceSigma") == 4.0);
  CHECK(chosen.at("iterations") == 3);
  CHECK(quell({"denoise", "--size", "8x8", "--preset", "best"}) != 0);
  CHECK(quell({"denoise", "--size", "8x8", "--demodulate", "gloss"}) == 1);
  CHECK(quell({"denoise", "--size", "8x8", "--signals", "3"}) != 0);
}

TEST_CASE("an output directory that cannot be made is an error and leaves nothing", "[cli]") {
  const TemporaryDirectory directory;
  io::writeTextFile(directory.path() + "/file", "in the way");
  CHECK(quell({"denoise", "--input", kData, "--frames", "15-15", "--output",
               directory.path() + "/file/out"}) == 1);
  CHECK(io::readFile(directory.path() + "/file") == "in the way");
}

TEST_CASE("host times and the copy bandwidth need no profiling queue", "[cli]") {
  const TemporaryDirectory directory;
  const std::string json = directory.path() + "/report.json";
  REQUIRE(quell({"denoise", "--size", "40x30", "--frame-count", "2", "--timers", "host", "--copy-bandwidth",
                 "--json", json}) == 0);
  const auto report = readJson(json);
  CHECK(report.at("time_source") == "host");
  CHECK(report.at("copy_ms").get<double>() > 0.0);
}

TEST_CASE("f-beta writes its table as a picture and finds it again", "[cli]") {
  const TemporaryDirectory directory;
  const std::string output = directory.file("table.exr"), cache = directory.file("cache");
  REQUIRE(quell({"f-beta", "--output", output, "--cache-directory", cache}) == 0);
  const io::Image built = io::readExr(output);
  CHECK(built.width == 256);
  CHECK(built.height == 256);
  REQUIRE(built.channels == 2);
  CHECK(built.at(255, 0, 0) == 1.0f);                           // a mirror seen from above reflects F0
  CHECK(built.at(0, 0, 1) == 1.0f);                             // and everything at grazing angles
  CHECK(built.at(255, 255, 0) == Approx(0.307).margin(0.001));  // the roughest surface loses two thirds
  REQUIRE(quell({"f-beta", "--output", output, "--cache-directory", cache}) == 0);
  CHECK(io::readExr(output).pixels == built.pixels);
  REQUIRE(quell({"f-beta", "--output", output, "--cache-directory", cache, "--correlated"}) == 0);
  CHECK(io::readExr(output).pixels != built.pixels);
  CHECK(quell({"f-beta"}) != 0);
  CHECK(quell({"f-beta", "--output", directory.file("none/table.exr"), "--no-cache"}) == 1);
}

TEST_CASE("devices are listed", "[cli]") { CHECK(quell({"devices"}) == 0); }

}  // namespace quell::tests
