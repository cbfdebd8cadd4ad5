// What C says about frames arrives as C++ has it.
#include <string>

#include "tests/core/c_denoiser.hpp"

namespace quell::tests {
namespace {

/// A denoiser that is not prepared: nothing is compiled.
struct Unprepared {
  Unprepared() : buffers(device, {}) {
    quell_denoiser* made = nullptr;
    REQUIRE(quellCreateDenoiser(device.context(), device.device(), device.queue(), nullptr, nullptr, &made) ==
            QUELL_SUCCESS);
    denoiser.reset(made);
    frame = toC(buffers.frame);
    output = toC(buffers.output);
  }

  quell_status memoryNeeded() {
    QUELL_INIT(use);
    return quellGetMemoryNeeded(denoiser.get(), &frame, &output, &use);
  }
  std::string bufferNames() {
    REQUIRE(memoryNeeded() == QUELL_SUCCESS);
    std::string names;
    for (std::size_t i = 0; i < use.bufferCount; ++i) {
      quell_buffer_use buffer;
      QUELL_INIT(buffer);
      REQUIRE(quellGetBufferUse(denoiser.get(), i, &buffer) == QUELL_SUCCESS);
      names += std::string(buffer.name) + " ";
    }
    return names;
  }

  OpenDevice device;
  FrameBuffers buffers;
  DenoiserHandle denoiser;
  quell_frame frame;
  quell_output output;
  quell_memory_use use;
};

}  // namespace

TEST_CASE("C knows the memory that is needed, and what is imported", "[core]") {
  Unprepared c;
  const Denoiser cxx(c.device.context, c.device.device, c.device.queue);
  CHECK_THAT(c.bufferNames(), !Catch::Contains("Imported"));
  CHECK(c.use.totalBytes == cxx.memoryNeeded(c.buffers.frame, c.buffers.output).totalBytes);
  c.frame.albedo.sum = QUELL_OVER_SAMPLE_COUNT;
  c.frame.radiance = quellPackedImage(nullptr, 4, QUELL_FLOAT32);
  c.frame.radiance.sum = QUELL_COUNT_IN_FOURTH;
  c.frame.positionWorld.channels = 0;
  c.frame.viewDepth = quellPackedImage(nullptr, 1, QUELL_FLOAT32);
  c.frame.depthKind = QUELL_DEPTH_REVERSED;
  if (c.device.device.getInfo<CL_DEVICE_IMAGE_SUPPORT>() != 0)
    c.frame.emission = quellImageObject(nullptr, 3);
  const std::string names = c.bufferNames();
  for (const char* name : {"albedoImported", "radianceImported", "viewDepthImported", "emissionImported"})
    CHECK_THAT(names, Catch::Contains(name));
}

TEST_CASE("C's kinds that do not exist are refused by name", "[core]") {
  Unprepared c;
  c.frame.albedo.sum = 3;
  checkError(c.memoryNeeded(), QUELL_INVALID_ARGUMENT, "albedo.sum");
  c.frame.albedo.sum = QUELL_NO_SUM;
  c.frame.depthKind = 5;
  checkError(c.memoryNeeded(), QUELL_INVALID_ARGUMENT, "depthKind");
  c.frame.depthKind = QUELL_DEPTH_VIEW;
  c.frame.albedo.format = 4;
  checkError(c.memoryNeeded(), QUELL_INVALID_ARGUMENT, "albedo.format");
}

TEST_CASE("C turns rows as C++ does", "[core]") {
  const Size size{37, 21};
  for (const ImageLayout& layout : {packed(3), packedHalf(4), interleaved(3)}) {
    const ImageView view = makeView(layout, size), turned = bottomUp(view, size);
    const quell_image_view c = quellBottomUp(toC(view), size.width, size.height);
    CHECK(c.offsetBytes == turned.offsetBytes);
    CHECK(c.rowPitchBytes == turned.rowPitchBytes);
  }
  CHECK(quellBottomUp(quellImageObject(nullptr, 3), 37, 21).rowPitchBytes ==
        bottomUp(imageObject(nullptr, 3), size).rowPitchBytes);
}

TEST_CASE("C asks what a method reads", "[core]") {
  const SettingsHandle settings;
  const std::vector<InputNeed> needs = inputNeeds(Settings());
  quell_input_need need;
  QUELL_INIT(need);
  checkError(quellGetInputNeed(settings.settings, 0, &need), QUELL_INVALID_ARGUMENT, "index");
  std::size_t count = 0;
  REQUIRE(quellCountInputNeeds(settings.settings, &count) == QUELL_SUCCESS);
  CHECK(count == needs.size());
  for (std::size_t i = 0; i < needs.size(); ++i) {
    REQUIRE(quellGetInputNeed(settings.settings, i, &need) == QUELL_SUCCESS);
    CHECK(need.image == needs[i].image);
    CHECK(need.use == static_cast<quell_input_use>(needs[i].use));
    CHECK(need.without == needs[i].without);
  }
  checkError(quellGetInputNeed(settings.settings, needs.size(), &need), QUELL_INVALID_ARGUMENT, "index");
}

}  // namespace quell::tests
