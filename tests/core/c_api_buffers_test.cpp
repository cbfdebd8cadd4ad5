// Intermediate buffers and the map of background through the C API.
#include <string>
#include <vector>

#include "tests/core/c_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kLastFrame = 2;

quell_background_map backgroundOf(CDenoiser& c, std::vector<unsigned char>& background) {
  quell_background_map map;
  QUELL_INIT(map);
  REQUIRE(quellGetBackgroundMap(c.denoiser.get(), background.data(), background.size(), &map) ==
          QUELL_SUCCESS);
  return map;
}

void checkNames(CDenoiser& c, const std::vector<std::string>& expected) {
  std::size_t count = 0;
  REQUIRE(quellCountBuffers(c.denoiser.get(), &count) == QUELL_SUCCESS);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) {
    const char* name = nullptr;
    REQUIRE(quellGetBufferName(c.denoiser.get(), i, &name) == QUELL_SUCCESS);
    names.push_back(name);
  }
  CHECK(names == expected);
  const char* beyond = nullptr;
  checkError(quellGetBufferName(c.denoiser.get(), count, &beyond), QUELL_INVALID_ARGUMENT, "index");
}

}  // namespace

TEST_CASE("intermediate buffers come through the C API", "[core][c]") {
  CDenoiser c({}, 0, QUELL_TIMERS_OFF, "beforeAntialiasing,irradiance");
  c.run(0, kLastFrame);
  Options options = testOptions();
  options.keptBuffers = {"beforeAntialiasing"};
  SmallDenoiser small({}, options);
  small.run(0, kLastFrame);
  const std::vector<float> expected = small.denoiser.readBuffer("beforeAntialiasing").values;

  quell_buffer_content content;
  QUELL_INIT(content);
  REQUIRE(quellReadBuffer(c.denoiser.get(), "beforeAntialiasing", nullptr, 0, &content) == QUELL_SUCCESS);
  CHECK(content.width == small.buffers.frame.size.width);
  CHECK(content.height == small.buffers.frame.size.height);
  REQUIRE(content.planes == 3);
  std::vector<float> values(expected.size());
  const auto read = [&](const char* name, std::size_t capacity) {
    return quellReadBuffer(c.denoiser.get(), name, values.data(), capacity, &content);
  };
  REQUIRE(read("beforeAntialiasing", values.size()) == QUELL_SUCCESS);
  CHECK(values == expected);
  checkError(read("beforeAntialiasing", values.size() - 1), QUELL_INVALID_ARGUMENT, "capacity");
  checkError(read("nothing", values.size()), QUELL_INVALID_ARGUMENT, "name");
  CHECK_THAT(quellErrorMessage(), Catch::Contains("irradiance"));
  checkNames(c, small.denoiser.bufferNames());

  std::vector<unsigned char> background;
  CHECK(backgroundOf(c, background).rows == content.height);
  const BackgroundMap expectedMap = small.denoiser.backgroundMap();
  background.resize(expectedMap.background.size());
  const quell_background_map map = backgroundOf(c, background);
  CHECK(background == expectedMap.background);
  CHECK(map.itemWidth * map.columns >= content.width);
  CHECK(map.share == expectedMap.share());
  REQUIRE(map.stageCount == expectedMap.stages.size());
  for (std::size_t i = 0; i < map.stageCount; ++i) {
    const char* label = nullptr;
    REQUIRE(quellGetBackgroundStage(c.denoiser.get(), i, &label) == QUELL_SUCCESS);
    CHECK(label == expectedMap.stages[i]);
  }
  quell_background_map again = map;
  checkError(quellGetBackgroundMap(c.denoiser.get(), background.data(), background.size() - 1, &again),
             QUELL_INVALID_ARGUMENT, "capacity");
}

TEST_CASE("names of severities", "[core][c]") {
  CHECK(std::string(quellSeverityName(QUELL_DOUBTFUL)) == "doubtful");
  CHECK(std::string(quellSeverityName(3)) == "unknown");
}

}  // namespace quell::tests
