// Preparing, live changes and captures through the C API.
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "tests/core/c_denoiser.hpp"

namespace quell::tests {

TEST_CASE("preparing on a thread, other settings and another queue work through the C API", "[core][c]") {
  CDenoiser c;
  const Picture expected = c.run(0, 1);
  quell_denoiser* denoiser = c.denoiser.get();
  const quell_frame frame = toC(c.buffers.frame);
  const quell_output output = toC(c.buffers.output);
  int steps = 0;
  quell_prepare_options options;
  QUELL_INIT(options);
  options.progress = [](const char*, int, int, void* user) { ++*static_cast<int*>(user); };
  options.user = &steps;
  REQUIRE(quellPrepareAsync(denoiser, &frame, &output, &options) == QUELL_SUCCESS);
  int ready = 0;
  for (int i = 0; i < 12000 && ready == 0; ++i) {
    REQUIRE(quellIsReady(denoiser, &ready) == QUELL_SUCCESS);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  REQUIRE(ready == 1);
  CHECK(steps > 8);
  CHECK(c.run(0, 1) == expected);

  SettingsHandle settings;
  REQUIRE(quellSetSetting(settings.settings, "exposure", "1") == QUELL_SUCCESS);
  CHECK(quellSetSettings(denoiser, settings.settings) == QUELL_SUCCESS);
  REQUIRE(quellSetSetting(settings.settings, "iterations", "2") == QUELL_SUCCESS);
  checkError(quellSetSettings(denoiser, settings.settings), QUELL_NOT_PREPARED, "iterations");

  quell_stage_kernel kernel;
  QUELL_INIT(kernel);
  std::size_t stages = 0;
  REQUIRE(quellCountStageKernels(denoiser, &frame, &output, &stages) == QUELL_SUCCESS);
  CHECK(stages > 8);
  for (std::size_t i = 0; i < stages; ++i) {
    REQUIRE(quellGetStageKernel(denoiser, i, &kernel) == QUELL_SUCCESS);
    CHECK(kernel.state == QUELL_KERNEL_BUILT);
  }
  CHECK(std::string(kernel.stage) == "temporal_antialiasing");
  checkError(quellGetStageKernel(denoiser, stages, &kernel), QUELL_INVALID_ARGUMENT, "index");

  quell_frame part = frame;
  part.renderWidth = 20;
  part.renderHeight = 10;
  checkError(quellDenoise(denoiser, &part, &output, 0, nullptr, nullptr), QUELL_NOT_PREPARED, "renderSize");

  const cl::CommandQueue other(c.device.context, c.device.device);
  REQUIRE(quellDenoiseOn(denoiser, other(), &frame, &output, 0, nullptr, nullptr) == QUELL_SUCCESS);
  other.finish();
  CHECK(quellCancelPrepare(denoiser) == QUELL_SUCCESS);
}

TEST_CASE("captures are written and run again through the C API", "[core][c]") {
  const TemporaryDirectory directory;
  OpenDevice device;
  const FrameBuffers buffers(device, {});
  const std::string path = directory.path();
  quell_options options;
  QUELL_INIT(options);
  options.cacheDirectory = "";
  options.captureDirectory = path.c_str();
  options.captureFrames = 1;
  quell_denoiser* made = nullptr;
  REQUIRE(quellCreateDenoiser(device.context(), device.device(), device.queue(), nullptr, &options, &made) ==
          QUELL_SUCCESS);
  DenoiserHandle denoiser(made);
  const quell_frame frame = toC(buffers.frame);
  const quell_output output = toC(buffers.output);
  REQUIRE(quellPrepare(made, &frame, &output) == QUELL_SUCCESS);
  cl_event done = nullptr;
  REQUIRE(quellDenoise(made, &frame, &output, 0, nullptr, &done) == QUELL_SUCCESS);
  Event(done).wait();
  quell_capture_state state;
  QUELL_INIT(state);
  for (int i = 0; i < 1000 && state.frames == 0; ++i) {  // a little after the frame
    REQUIRE(quellGetCaptureState(made, &state) == QUELL_SUCCESS);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  CHECK(state.frames == 1);
  CHECK(std::string(state.problem).empty());
  quell_replay replay;
  QUELL_INIT(replay);
  REQUIRE(quellReplay(path.c_str(), device.context(), device.device(), device.queue(), "", &replay) ==
          QUELL_SUCCESS);
  CHECK(replay.equal == 1);
  CHECK(replay.frameCount == 1);
  CHECK(replay.differenceCount == 0);
  CHECK_THAT(replay.text, Catch::Contains("bit for bit"));
  checkError(quellReplay("/nowhere", device.context(), device.device(), device.queue(), nullptr, &replay),
             QUELL_FILE_ERROR, "/nowhere");
}

}  // namespace quell::tests
