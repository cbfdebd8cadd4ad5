// Layouts that prepare() refuses. After any of them the denoiser is as if never prepared, and can be prepared
// again.
#include <functional>
#include <limits>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

struct Spoiled {
  Refusal refusal;
  std::function<void(Frame&, Output&)> spoil;
};

Refusal invalid(const std::string& buffer, const std::string& expected, const std::string& got) {
  return {ErrorCode::InvalidArgument, "prepare", buffer, expected, got};
}

// One by one on the same denoiser.
void checkAll(const std::vector<Spoiled>& cases) {
  SmallDenoiser small;
  for (const Spoiled& spoiled : cases) {
    Frame frame = small.buffers.frame;
    Output output = small.buffers.output;
    spoiled.spoil(frame, output);
    INFO(spoiled.refusal.buffer << " " << spoiled.refusal.got);
    checkRefused(spoiled.refusal, [&] { small.denoiser.prepare(frame, output); });
    CHECK(small.denoiser.memoryUse().totalBytes == 0);
    checkRefused({ErrorCode::NotPrepared, "denoise", "", "prepare()", "none"}, [&] { small.enqueue(); });
  }
  small.denoiser.prepare(small.buffers.frame, small.buffers.output);
  checkStillWorks(small);
}

constexpr std::size_t kFloat = sizeof(float);

}  // namespace

TEST_CASE("sizes that are empty, negative or huge are refused", "[errors]") {
  std::vector<Spoiled> cases;
  for (const Size size :
       {Size{0, 21}, Size{37, 0}, Size{-1, 21}, Size{37, -1}, Size{32769, 1}, Size{1, 32769},
        Size{32768, 32768}, Size{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()}}) {
    cases.push_back({invalid("size", "1x1 to 32768x32768",
                             std::to_string(size.width) + "x" + std::to_string(size.height)),
                     [size](Frame& frame, Output&) { frame.size = size; }});
  }
  checkAll(cases);
}

TEST_CASE("missing and contradicting images are refused", "[errors]") {
  checkAll({
      {invalid("radiance", "an image", "none"), [](Frame& f, Output&) { f.radiance = {}; }},
      {invalid("normalWorld", "an image", "none"), [](Frame& f, Output&) { f.normalWorld = {}; }},
      {invalid("positionWorld", "either positionWorld or viewDepth", "none"),
       [](Frame& f, Output&) { f.positionWorld = {}; }},
      {invalid("positionWorld", "either positionWorld or viewDepth", "both"),
       [](Frame& f, Output&) { f.viewDepth = packedImage(nullptr, 1); }},
      {invalid("output", "a linear or a display image", "none"), [](Frame&, Output& o) { o = {}; }},
  });
}

TEST_CASE("channel counts out of range are refused", "[errors]") {
  struct Image {
    const char* name;
    ImageView Frame::*input;
    ImageView Output::*output;
    int least, most;
  };
  const Image images[] = {
      {"radiance", &Frame::radiance, nullptr, 1, 4},
      {"normalWorld", &Frame::normalWorld, nullptr, 3, 4},
      {"positionWorld", &Frame::positionWorld, nullptr, 3, 4},
      {"viewDepth", &Frame::viewDepth, nullptr, 1, 1},
      {"albedo", &Frame::albedo, nullptr, 1, 4},
      {"glossColor", &Frame::glossColor, nullptr, 1, 4},
      {"emission", &Frame::emission, nullptr, 1, 4},
      {"glossyRadiance", &Frame::glossyRadiance, nullptr, 1, 4},
      {"roughness", &Frame::roughness, nullptr, 1, 1},
      {"f0", &Frame::f0, nullptr, 1, 4},
      {"motion", &Frame::motion, nullptr, 2, 4},
      {"objectId", &Frame::objectId, nullptr, 1, 1},
      {"output.linear", nullptr, &Output::linear, 3, 4},
      {"output.display", nullptr, &Output::display, 3, 4},
  };
  std::vector<Spoiled> cases;
  for (const Image& image : images) {
    for (const int channels : {-1, 1, 2, 5}) {
      if (channels >= image.least && channels <= image.most) continue;
      cases.push_back(
          {invalid(image.name,
                   std::to_string(image.least) + " to " + std::to_string(image.most) + " channels",
                   std::to_string(channels)),
           [image, channels](Frame& frame, Output& output) {
             (image.input != nullptr ? frame.*image.input : output.*image.output).channels = channels;
           }});
    }
  }
  CHECK(cases.size() == 14 * 2 + 4 * 1 + 4 * 2);
  checkAll(cases);
}

TEST_CASE("integers are refused for all but object ids", "[errors]") {
  const auto integers = [](ImageView Frame::*image) {
    return [image](Frame& frame, Output&) { (frame.*image).format = ComponentFormat::UInt32; };
  };
  const auto output = [](Frame&, Output& o) { o.display.format = ComponentFormat::UInt32; };
  checkAll({{invalid("radiance", "floats or halves", "32-bit unsigned"), integers(&Frame::radiance)},
            {invalid("albedo", "floats or halves", "32-bit unsigned"), integers(&Frame::albedo)},
            {invalid("output.display", "floats or halves", "32-bit unsigned"), output}});
}

TEST_CASE("strides, pitches and offsets that do not fit the components are refused", "[errors]") {
  const std::size_t row = 37 * 3 * kFloat;
  checkAll({
      {invalid("radiance", "a pixel stride of at least 12 bytes", "8"),
       [](Frame& f, Output&) { f.radiance.pixelStrideBytes = 8; }},
      {invalid("albedo", "in multiples of 4", "13"),
       [](Frame& f, Output&) { f.albedo.pixelStrideBytes = 13; }},
      {invalid("normalWorld", "a row pitch of at least " + std::to_string(row), std::to_string(row - 4)),
       [row](Frame& f, Output&) { f.normalWorld.rowPitchBytes = row - 4; }},
      {invalid("output.linear", "in multiples of 4", std::to_string(row + 2)),
       [row](Frame&, Output& o) { o.linear.rowPitchBytes = row + 2; }},
      {invalid("emission", "an offset in multiples of 4 bytes", "6"),
       [](Frame& f, Output&) { f.emission.offsetBytes = 6; }},
      {invalid("positionWorld", "an offset in multiples of 2 bytes", "3"),
       [](Frame& f, Output&) {
         f.positionWorld.format = ComponentFormat::Float16;
         f.positionWorld.offsetBytes = 3;
       }},
  });
}

TEST_CASE("layouts that reach beyond what kernels can count are refused, and none overflows", "[errors]") {
  constexpr std::size_t kComponents = std::size_t{1} << 31;
  const std::string expected = "up to";
  checkAll({
      {invalid("radiance", expected, ""),
       [](Frame& f, Output&) { f.radiance.offsetBytes = kComponents * kFloat; }},
      {invalid("radiance", expected, ""),
       [](Frame& f, Output&) { f.radiance.rowPitchBytes = kComponents / 20 * kFloat + 4096; }},
      {invalid("radiance", expected, ""),
       [](Frame& f, Output&) { f.radiance.rowPitchBytes = std::size_t{1} << 62; }},
      // Twenty rows of these wrap around to a small number of bytes.
      {invalid("radiance", expected, ""),
       [](Frame& f, Output&) { f.radiance.rowPitchBytes = (std::size_t{1} << 62) + 444; }},
      {invalid("radiance", expected, ""),
       [](Frame& f, Output&) { f.radiance.pixelStrideBytes = std::size_t{1} << 62; }},
      {invalid("radiance", expected, ""),
       [](Frame& f, Output&) { f.radiance.offsetBytes = ~std::size_t{3}; }},
  });
}

}  // namespace quell::tests
