// Layouts that prepare() refuses. After any of them the denoiser is as it was before.
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
  const std::size_t bytes = small.denoiser.memoryUse().totalBytes;
  for (const Spoiled& spoiled : cases) {
    Frame frame = small.buffers.frame;
    Output output = small.buffers.output;
    spoiled.spoil(frame, output);
    INFO(spoiled.refusal.buffer << " " << spoiled.refusal.got);
    checkRefused(spoiled.refusal, [&] { small.denoiser.prepare(frame, output); });
    CHECK(small.denoiser.memoryUse().totalBytes == bytes);
  }
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
  std::vector<Spoiled> cases;
  const auto addCases = [&](const std::string& name, const ImageFacts& facts, auto select) {
    for (const int channels : {-1, 1, 2, 5}) {
      if (channels >= facts.leastChannels && channels <= facts.mostChannels) continue;
      cases.push_back({invalid(name,
                               std::to_string(facts.leastChannels) + " to " +
                                   std::to_string(facts.mostChannels) + " channels",
                               std::to_string(channels)),
                       [=](Frame& frame, Output& output) { select(frame, output).channels = channels; }});
    }
  };
  for (const auto& image : kInputs<Frame>)
    addCases(image.name, image, [&image](Frame& f, Output&) -> ImageView& { return f.*image.member; });
  for (const auto& image : kOutputs<Output>)
    addCases(std::string("output.") + image.name, image,
             [&image](Frame&, Output& o) -> ImageView& { return o.*image.member; });
  CHECK(cases.size() >= 2 * (std::size(kInputs<Frame>) + std::size(kOutputs<Output>)));
  checkAll(cases);
}

TEST_CASE("integers are refused for all but object ids", "[errors]") {
  std::vector<Spoiled> cases;
  for (const auto& image : kInputs<Frame>)
    if (image.member != &Frame::objectId)
      cases.push_back(
          {invalid(image.name, "floats or halves", "32-bit unsigned"), [&image](Frame& f, Output&) {
             f.*image.member = packedImage(nullptr, image.leastChannels, ComponentFormat::UInt32);
           }});
  cases.push_back({invalid("output.display", "floats or halves", "32-bit unsigned"),
                   [](Frame&, Output& o) { o.display.format = ComponentFormat::UInt32; }});
  checkAll(cases);
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
      {invalid("albedo", "an offset of at least " + std::to_string(20 * row), "0"),
       [row](Frame& f, Output&) { f.albedo.rowPitchBytes = -static_cast<std::ptrdiff_t>(row); }},
      {invalid("albedo", "a row pitch of at least " + std::to_string(row), "-4"),
       [](Frame& f, Output&) { f.albedo.rowPitchBytes = -4; }},
      {invalid("albedo", "no offset, pixel stride or row pitch", "stride 16"),
       [](Frame& f, Output&) {
         f.albedo = imageObject(nullptr, 3);
         f.albedo.pixelStrideBytes = 16;
       }},
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
