// quell render as a user runs it: files, resuming, messages.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/cli/run_tool.hpp"
#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/frame_sequence.hpp"
#include "host/io/halton.hpp"
#include "host/metrics/display_encoding.hpp"
#include "host/metrics/error.hpp"
#include "host/render/render_sequence.hpp"
#include "tests/render/render_support.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/temporary_directory.hpp"

namespace quell::tests {
namespace {

namespace fs = std::filesystem;

render::RenderOptions smallOptions(const std::string& output) {
  render::RenderOptions options;
  options.settings.scene = "roughness";
  options.settings.size = {32, 18};
  options.settings.referenceSamples = 4;
  options.frameCount = 3;
  options.output = output;
  options.device = testDevice();
  options.cacheDirectory = defaultCacheDirectory();
  return options;
}

int quell(std::vector<std::string> arguments) {
  std::vector<const char*> argv = {"quell"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return cli::runTool(static_cast<int>(argv.size()), argv.data());
}

// Largest distance between where a primary ray went and where its position projects, pixels.
double worstOffSamplePx(const io::FrameData& frame) {
  const io::Image& position = frame.positionWorld;
  double worst = 0.0;
  for (int y = 0; y < position.height; ++y) {
    for (int x = 0; x < position.width; ++x) {
      const glm::dvec3 p = pixel3(position, x, y);
      if (pixel3(frame.normalWorld, x, y) == glm::dvec3(0.0)) continue;
      const auto clip = [&](std::size_t r) {
        const double* row = &frame.camera.worldToClip[4 * r];
        return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
      };
      const double column = (0.5 + 0.5 * clip(0) / clip(3)) * position.width - frame.camera.jitterPx[0];
      const double row = (0.5 - 0.5 * clip(1) / clip(3)) * position.height - frame.camera.jitterPx[1];
      worst = std::max(worst, std::hypot(column - x - 0.5, row - y - 0.5));
    }
  }
  return worst;
}

double encodedDifference(const io::Image& a, const io::Image& b) {
  return metrics::rmse(metrics::encodeForDisplay(a), metrics::encodeForDisplay(b));
}

const std::vector<std::string> kBuffers = {
    "color",  "diffuse_irradiance", "glossy_radiance", "albedo",    "gloss_color",  "f0",       "emission",
    "motion", "shading_normal",     "world_position",  "roughness", "hit_distance", "object_id"};

}  // namespace

TEST_CASE("a rendered directory is a sequence with references", "[render]") {
  const TemporaryDirectory directory;
  const std::string out = directory.file("out");
  const render::RenderReport report = render::renderSequence(smallOptions(out));
  CHECK(report.framesRendered == 3);
  CHECK(report.halvesRendered == 2);
  for (const std::string& buffer : kBuffers)
    for (const char* frame : {"_0000.exr", "_0001.exr", "_0002.exr"})
      CHECK(io::readExr(out + "/" + buffer + frame).width == 32);

  const auto sequence = io::openSequence(out);
  CHECK(sequence->width() == 32);
  CHECK(sequence->height() == 18);
  CHECK(sequence->frames() == std::vector<int>{0, 1, 2});
  CHECK_FALSE(sequence->hasReference(1, io::ReferenceKind::Centre));
  const io::Reference reference = sequence->reference(2, io::ReferenceKind::Centre);
  CHECK(reference.a.pixels != reference.b.pixels);
  const io::FrameData first = sequence->read(1), second = sequence->read(2);
  CHECK(second.camera.worldToClipPrev == first.camera.worldToClip);
  CHECK(second.camera.worldToClip != first.camera.worldToClip);
  CHECK(second.hitDistance.channels == 1);
  CHECK(*std::max_element(second.hitDistance.pixels.begin(), second.hitDistance.pixels.end()) > 0.0f);
}

TEST_CASE("a jittered rendering says so and has both kinds of reference", "[render]") {
  const TemporaryDirectory directory;
  const std::string out = directory.file("out");
  render::RenderOptions options = smallOptions(out);
  options.settings.jitter = true;
  CHECK(render::renderSequence(options).halvesRendered == 4);
  const auto sequence = io::openSequence(out);
  CHECK(sequence->jittered());
  for (const int frame : sequence->frames()) {
    const io::FrameData data = sequence->read(frame);
    CHECK(data.camera.jitterPx == io::jitterPxOf(frame));
    CHECK(worstOffSamplePx(data) < 0.01);
  }
  using Kind = io::ReferenceKind;
  CHECK(sequence->reference(2, Kind::Antialiased).a.pixels !=
        sequence->reference(2, Kind::Antialiased).b.pixels);
  CHECK(sequence->reference(2, Kind::Antialiased).a.pixels != sequence->reference(2, Kind::Centre).a.pixels);
  CHECK(render::renderSequence(options).halvesKept == 4);
  options.settings.jitter = false;
  REQUIRE_THROWS_MATCHES(render::renderSequence(options), Error,
                         failsWith(ErrorCode::InvalidArgument, {"render.json", "jitter"}));
}

TEST_CASE("an antialiased picture is the mean over the pixel", "[render]") {
  constexpr int kGrid = 8, kSamples = 8;
  render::PathTracer tracer = makeTracer({32, 18});
  render::Scene scene = render::makeScene(render::findScene("roughness"), 0);
  io::Image mean(32, 18, 3);
  const auto add = [&](std::array<double, 2> jitterPx, std::uint32_t seed, int samples, io::Image& sum) {
    scene.camera.jitterPx = jitterPx;
    const render::Features features = tracer.features(scene, scene);
    const io::Image color = render::composeColor(features, tracer.light(seed, samples));
    for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += color.pixels[i];
  };
  for (int i = 0; i < kGrid * kGrid; ++i)
    add({(i % kGrid + 0.5) / kGrid - 0.5, (i / kGrid + 0.5) / kGrid - 0.5}, std::uint32_t(i), kSamples, mean);
  for (float& value : mean.pixels) value /= kGrid * kGrid;
  io::Image centre(32, 18, 3);
  add({0.0, 0.0}, 99, kGrid * kGrid * kSamples, centre);
  const io::Image antialiased = tracer.antialiased(scene, scene, 7, kGrid * kGrid * kSamples);
  CHECK(encodedDifference(antialiased, mean) < 0.3 * encodedDifference(antialiased, centre));
}

TEST_CASE("color is what its parts add up to", "[render]") {
  const TemporaryDirectory directory;
  const std::string out = directory.file("out");
  render::renderSequence(smallOptions(out));
  const auto read = [&](const std::string& buffer) {
    return io::readExr(out + "/" + buffer + "_0002.exr").pixels;
  };
  const auto color = read("color"), albedo = read("albedo"), diffuse = read("diffuse_irradiance"),
             tint = read("gloss_color"), glossy = read("glossy_radiance"), emission = read("emission");
  for (std::size_t i = 0; i < color.size(); ++i)
    REQUIRE(color[i] ==
            Approx(albedo[i] * diffuse[i] + tint[i] * glossy[i] + emission[i]).epsilon(2e-3).margin(1e-4));
  std::vector<float> ids = io::readExr(out + "/object_id_0002.exr").pixels;
  for (const float id : ids) REQUIRE(id == std::round(id));
}

TEST_CASE("32-bit object ids survive their file", "[render]") {
  const TemporaryDirectory directory;
  io::Image ids(3, 1, 1);
  ids.pixels = {0.0f, 2049.0f, 16777215.0f};  // a half would round the second
  io::writeExr(directory.file("id.exr"), ids, io::ExrType::Uint);
  CHECK(io::readExr(directory.file("id.exr")).pixels == ids.pixels);
  ids.pixels = {-5.0f, std::nanf(""), 1e20f};
  io::writeExr(directory.file("id.exr"), ids, io::ExrType::Uint);
  CHECK(io::readExr(directory.file("id.exr")).pixels == std::vector<float>{0.0f, 0.0f, 4294967040.0f});
}

TEST_CASE("rendering resumes where it was cut off", "[render]") {
  const TemporaryDirectory directory;
  const std::string out = directory.file("out");
  render::RenderOptions options = smallOptions(out);
  render::renderSequence(options);
  const std::string whole = io::readFile(out + "/glossy_radiance_0001.exr");
  const std::string half = io::readFile(out + "/ref_b_color_0002.exr");

  SECTION("nothing is missing") {
    const render::RenderReport again = render::renderSequence(options);
    CHECK(again.framesKept == 3);
    CHECK(again.framesRendered == 0);
    CHECK(again.halvesKept == 2);
  }
  SECTION("a file was cut short and another is gone") {
    fs::resize_file(out + "/glossy_radiance_0001.exr", whole.size() / 2);
    fs::remove(out + "/ref_b_color_0002.exr");
    const render::RenderReport again = render::renderSequence(options);
    CHECK(again.framesRendered == 1);
    CHECK(again.halvesRendered == 1);
    CHECK(io::readFile(out + "/glossy_radiance_0001.exr") == whole);
    CHECK(io::readFile(out + "/ref_b_color_0002.exr") == half);
  }
  SECTION("more frames, then fewer: cameras stay those of all frames") {
    options.frameCount = 4;
    options.settings.referenceSamples = 0;
    CHECK(render::renderSequence(options).framesRendered == 1);
    options.frameCount = 2;
    CHECK(render::renderSequence(options).framesKept == 2);
    CHECK(io::openSequence(out)->frames().size() == 4);
  }
  SECTION("another rendering is refused") {
    options.settings.seed = 9;
    REQUIRE_THROWS_MATCHES(render::renderSequence(options), Error,
                           failsWith(ErrorCode::InvalidArgument, {"render.json", "seed"}));
    options.settings.seed = 1;
    options.settings.referenceSamples = 8;
    REQUIRE_THROWS_MATCHES(render::renderSequence(options), Error,
                           failsWith(ErrorCode::InvalidArgument, {"reference_samples"}));
  }
}

TEST_CASE("the seed decides the noise and nothing else", "[render]") {
  const TemporaryDirectory directory;
  render::RenderOptions options = smallOptions(directory.file("a"));
  options.settings.referenceSamples = 0;
  options.frameCount = 1;
  render::renderSequence(options);
  options.output = directory.file("b");
  render::renderSequence(options);
  options.output = directory.file("c");
  options.settings.seed = 2;
  render::renderSequence(options);
  for (const std::string& buffer : kBuffers) {
    const std::string a = io::readFile(directory.file("a/" + buffer + "_0000.exr"));
    CAPTURE(buffer);
    CHECK(a == io::readFile(directory.file("b/" + buffer + "_0000.exr")));
    const bool noisy = buffer == "color" || buffer == "diffuse_irradiance" || buffer == "glossy_radiance" ||
                       buffer == "hit_distance";
    CHECK((a != io::readFile(directory.file("c/" + buffer + "_0000.exr"))) == noisy);
  }
}

TEST_CASE("references are of the last frame, and of the one before the switch", "[render]") {
  CHECK(render::defaultReferenceFrames(render::findScene("cornell"), 30) == std::vector<int>{29});
  CHECK(render::defaultReferenceFrames(render::findScene("light-switch"), 30) == std::vector<int>{19, 29});
  CHECK(render::defaultReferenceFrames(render::findScene("light-switch"), 12) == std::vector<int>{11});
}

TEST_CASE("what cannot be rendered is refused with a reason", "[render]") {
  const TemporaryDirectory directory;
  render::RenderOptions options = smallOptions(directory.file("out"));
  SECTION("scene") {
    options.settings.scene = "nowhere";
    REQUIRE_THROWS_MATCHES(render::renderSequence(options), Error,
                           failsWith(ErrorCode::InvalidArgument, {"nowhere", "cornell", "light-switch"}));
  }
  SECTION("size") {
    options.settings.size = {0, 18};
    REQUIRE_THROWS_MATCHES(render::renderSequence(options), Error,
                           failsWith(ErrorCode::InvalidArgument, {"0x18"}));
  }
  SECTION("counts") {
    options.frameCount = 0;
    REQUIRE_THROWS_MATCHES(render::renderSequence(options), Error,
                           failsWith(ErrorCode::InvalidArgument, {"frames"}));
    options.frameCount = 2;
    options.settings.samples = 0;
    REQUIRE_THROWS_MATCHES(render::renderSequence(options), Error,
                           failsWith(ErrorCode::InvalidArgument, {"spp"}));
    options.settings.samples = 1;
    options.referenceFrames = {2};
    REQUIRE_THROWS_MATCHES(render::renderSequence(options), Error,
                           failsWith(ErrorCode::InvalidArgument, {"reference-frames"}));
  }
  SECTION("a file where the directory should be") {
    std::ofstream(directory.file("file")) << "x";
    options.output = directory.file("file/out");
    REQUIRE_THROWS_MATCHES(render::renderSequence(options), Error,
                           failsWith(ErrorCode::FileError, {"file/out"}));
  }
  CHECK_FALSE(fs::exists(directory.file("out")));  // refused before anything is written
}

TEST_CASE("quell render renders and quell denoise takes it", "[render]") {
  const TemporaryDirectory directory;
  const std::string out = directory.file("out");
  REQUIRE(quell({"render", "--scene", "cornell", "--frames", "2", "--size", "64x36", "--spp", "2",
                 "--reference", "4", "--reference-frames", "0,1", "--output", out}) == 0);
  CHECK(fs::exists(out + "/ref_b_glossy_radiance_0000.exr"));
  const auto camera = nlohmann::json::parse(io::readFile(out + "/camera.json"));
  CHECK(camera.at("width") == 64);
  CHECK(camera.at("height") == 36);
  REQUIRE(camera.at("frames").size() == 2);
  CHECK(camera.at("frames").at(1).at("frame") == 1);
  REQUIRE(quell({"denoise", "--input", out, "--output", directory.file("denoised")}) == 0);
  CHECK(fs::exists(directory.file("denoised/comparison_0001.png")));
  CHECK(quell({"render", "--scene", "nowhere", "--output", out}) == 1);
  CHECK(quell({"render", "--scene", "cornell"}) != 0);
  CHECK(quell({"render", "--scene", "cornell", "--output", out, "--reference-frames", "0"}) == 1);
}

}  // namespace quell::tests
