// Frames that were captured run once more, bit for bit; damaged captures give a sentence.
#include <filesystem>
#include <fstream>

#include "host/core/fnv1a.hpp"
#include "tests/support/small_denoiser.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

namespace fs = std::filesystem;

Options capturing(const std::string& directory, int frames = 3) {
  Options options = testOptions();
  options.captureDirectory = directory;
  options.captureFrames = frames;
  return options;
}

int replayed(const std::string& directory) { return quell({"replay", directory, "--no-cache"}); }

// Every way to hand over an image that is neither packed floats nor alone in its buffer.
ImageSetup oddLayouts() {
  ImageSetup setup;
  setup.radiance = interleaved(3);
  setup.albedo = packedHalf(4);
  setup.objectId = {ComponentFormat::UInt32, 1, 0, 0, 3};
  setup.motion = packed(2);
  setup.viewDepth = packed(1);
  setup.positionWorld = absent();
  setup.display = interleaved(3, ComponentFormat::Float16);
  return setup;
}

std::string captureOf(const ImageSetup& setup, const std::string& directory, int last) {
  SmallDenoiser small(setup, capturing(directory));
  small.buffers.frame.albedo = summed(small.buffers.frame.albedo, Sum::OverSampleCount);
  small.buffers.frame.depthKind = DepthKind::NegativeView;
  small.buffers.frame.sampleCount = 3.0;
  small.denoiser.prepare(small.buffers.frame, small.buffers.output);
  small.run(0, last);
  return small.denoiser.captureState().directory;
}

void writeFile(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("captured frames run again, bit for bit", "[cli]") {
  const TemporaryDirectory directory;
  const std::string folder = captureOf(oddLayouts(), directory.path(), 4);
  // Each prepare() has a folder; the first had no frames.
  CHECK(fs::path(folder).filename() == "0002");
  CHECK(fs::exists(fs::path(folder) / "frame_0002.bin"));
  CHECK_FALSE(fs::exists(fs::path(folder) / "frame_0003.bin"));
  CHECK(replayed(folder) == 0);
}

TEST_CASE("a replay says that outputs differ", "[cli]") {
  const TemporaryDirectory directory;
  const std::string folder = captureOf({}, directory.path(), 0);
  const fs::path file = fs::path(folder) / "frame_0000.bin";
  // A setting that changes the picture: the file is as if written by another build.
  std::string text = io::readFile(file.string());
  const std::size_t end = text.find("\nend ") + 1;
  const std::size_t place = text.find("setting exposure\nvalue 0\n");
  REQUIRE(place < end);
  std::string lines = text.substr(0, end);
  lines.replace(place, 25, "setting exposure\nvalue 1\n");
  char hash[24];
  std::snprintf(hash, sizeof(hash), "end %016llx",
                static_cast<unsigned long long>(fnv1a(lines.data(), lines.size())));
  writeFile(file, lines + hash + text.substr(end + 20));
  CHECK(replayed(folder) == 1);
}

TEST_CASE("damaged captures give a sentence", "[cli]") {
  const TemporaryDirectory directory;
  const std::string folder = captureOf({}, directory.path(), 0);
  const fs::path file = fs::path(folder) / "frame_0000.bin";
  const std::string whole = io::readFile(file.string());
  const auto sentence = [&](const std::string& path) {
    return errorStreamOf({"replay", path, "--no-cache"}, 1, directory.file("stderr"));
  };
  const auto damaged = [&](const std::string& bytes) {
    writeFile(file, bytes);
    return sentence(folder);
  };
  CHECK_THAT(damaged(""), Catch::Contains("frame_0000.bin") && Catch::Contains("an empty file"));
  CHECK_THAT(damaged(whole.substr(0, 100)), Catch::Contains("lines of text with a checksum"));
  CHECK_THAT(damaged(whole.substr(0, whole.size() - 1)), Catch::Contains("bytes of an image"));
  CHECK_THAT(damaged(whole + "x"), Catch::Contains("a file of " + std::to_string(whole.size()) + " bytes"));
  std::string flipped = whole;
  flipped.back() = static_cast<char>(flipped.back() ^ 1);
  CHECK_THAT(damaged(flipped), Catch::Contains("the checksum of a content differs"));
  flipped = whole;
  flipped[30] = 'x';
  CHECK_THAT(damaged(flipped), Catch::Contains("the checksum differs"));
  fs::remove(file);
  CHECK_THAT(sentence(folder), Catch::Contains("captured frames from frame_0000.bin on"));
  CHECK_THAT(sentence(directory.file("nowhere")), Catch::Contains("no folder"));
  writeFile(fs::path(folder) / "capture.txt", "quell-capture 1\n");
  CHECK_THAT(sentence(folder), Catch::Contains("capture.txt"));
}

TEST_CASE("image objects and pending frames and later beginnings are captured as well", "[cli]") {
  const TemporaryDirectory directory;
  Options options = capturing(directory.path(), 2);
  options.captureSkip = 2;  // there is a history then
  SmallDenoiser small({}, options, CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
  const cl::Image2D image(small.device.context, CL_MEM_READ_WRITE, cl::ImageFormat(CL_RGBA, CL_FLOAT), 40,
                          30);
  Output output = small.buffers.output;
  output.display = bottomUp(imageObject(image(), 3), small.buffers.frame.size);
  Frame frame = small.buffers.frame;
  frame.camera.worldToClipPrev = {};
  small.denoiser.prepare(frame, output);
  Gate gate(small.device.context);
  for (int i = 0; i < 3; ++i)
    small.denoiser.denoise(frame, output,
                           i == 0 ? std::vector<cl_event>{gate.event()} : std::vector<cl_event>{});
  const Event last = small.denoiser.denoise(frame, output);
  CHECK(small.denoiser.captureState().frames == 0);  // nothing waited for the gate
  gate.open();
  last.wait();
  const std::string folder = small.denoiser.captureState().directory;
  small.denoiser =
      Denoiser(small.device.context, small.device.device, small.device.queue);  // ends the capture
  CHECK(replayed(folder) == 0);
  CHECK(replayed(directory.path()) == 1);  // the first prepare() had no frames
}

TEST_CASE("the environment asks for captures as well", "[cli]") {
  const TemporaryDirectory directory;
  setenv("QUELL_CAPTURE", directory.path().c_str(), 1);
  CHECK(SmallDenoiser().denoiser.captureState().directory == directory.file("0001"));
  Options none = testOptions();
  none.captureDirectory = "";
  CHECK(SmallDenoiser({}, none).denoiser.captureState().directory.empty());
  unsetenv("QUELL_CAPTURE");
  CHECK(SmallDenoiser().denoiser.captureState().directory.empty());
}

TEST_CASE("a capture that cannot be written never stops a frame", "[cli]") {
  const TemporaryDirectory directory;
  const Picture expected = SmallDenoiser().run(0, 1);
  const std::string file = directory.file("file");
  writeFile(file, "x");
  SmallDenoiser small({}, capturing(file + "/captures"));
  CHECK(small.run(0, 1) == expected);
  CHECK_FALSE(small.denoiser.captureState().problem.empty());
  SmallDenoiser full({}, capturing("/dev/full"));
  CHECK(full.run(0, 1) == expected);
  CHECK_FALSE(full.denoiser.captureState().problem.empty());
}

}  // namespace quell::tests
