// The C API: the same denoiser, settings and devices.
#include <catch2/catch.hpp>
#include <cstring>
#include <string>
#include <vector>

#include "tests/core/c_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kLastFrame = 2;

}  // namespace

TEST_CASE("C and C++ give the same picture, bit by bit", "[core][c]") {
  ImageSetup setup;
  setup.objectId = {ComponentFormat::UInt32, 1};
  setup.objectId.offset = 5;
  setup.albedo.rowPadding = 11;
  CDenoiser c(setup);
  const Picture picture = c.run(0, kLastFrame);
  CHECK(picture == SmallDenoiser(setup).run(0, kLastFrame));
  REQUIRE(quellResetHistory(c.denoiser.get()) == QUELL_SUCCESS);
  CHECK(c.run(0, kLastFrame) == picture);
}

TEST_CASE("wait lists work through the C API, and the event is optional", "[core][c]") {
  CDenoiser c({}, CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
  const Picture expected = SmallDenoiser().run(0, 0);
  c.buffers.upload(0);
  const quell_frame frame = toC(c.buffers.frame);
  const quell_output output = toC(c.buffers.output);
  {
    Gate gate(c.device.context);
    const cl_event wait = gate.event();
    cl_event done = nullptr;
    REQUIRE(quellDenoise(c.denoiser.get(), &frame, &output, 1, &wait, &done) == QUELL_SUCCESS);
    const Event event(done);
    CHECK(statusOf(event) > CL_RUNNING);
    gate.open();
    event.wait();
  }
  CHECK(c.buffers.download() == expected);
  REQUIRE(quellResetHistory(c.denoiser.get()) == QUELL_SUCCESS);
  REQUIRE(quellDenoise(c.denoiser.get(), &frame, &output, 0, nullptr, nullptr) == QUELL_SUCCESS);
  c.denoiser.reset();
  c.device.queue.finish();
  CHECK(c.buffers.download() == expected);
}

TEST_CASE("memory and times come part by part", "[core][c]") {
  CDenoiser c({}, CL_QUEUE_PROFILING_ENABLE, QUELL_TIMERS_HOST);
  quell_memory_use use;
  QUELL_INIT(use);
  REQUIRE(quellGetMemoryUse(c.denoiser.get(), &use) == QUELL_SUCCESS);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < use.bufferCount; ++i) {
    quell_buffer_use buffer;
    QUELL_INIT(buffer);
    REQUIRE(quellGetBufferUse(c.denoiser.get(), i, &buffer) == QUELL_SUCCESS);
    CHECK(std::strlen(buffer.name) > 0);
    sum += buffer.bytes;
  }
  CHECK(sum == use.totalBytes);
  CHECK(sum > 0);
  quell_buffer_use beyond;
  QUELL_INIT(beyond);
  checkError(quellGetBufferUse(c.denoiser.get(), use.bufferCount, &beyond), QUELL_INVALID_ARGUMENT, "index");

  c.run(0, kLastFrame);
  c.device.queue.finish();
  quell_timings timings;
  QUELL_INIT(timings);
  // Completion callbacks may come a little after the queue has finished.
  while (timings.frame.count < kLastFrame + 1)
    REQUIRE(quellGetTimings(c.denoiser.get(), &timings) == QUELL_SUCCESS);
  CHECK(timings.source == QUELL_TIME_HOST);
  CHECK(timings.frame.count == kLastFrame + 1);
  REQUIRE(timings.stageCount > 0);
  quell_stage_timings stage;
  QUELL_INIT(stage);
  REQUIRE(quellGetStageTimings(c.denoiser.get(), 0, &stage) == QUELL_SUCCESS);
  CHECK(std::string(stage.stage) == "accumulate_noisy");
  CHECK(stage.time.count == kLastFrame + 1);
  CHECK(stage.bytesMoved > 0);
  CHECK(std::string(stage.label) == "accumulate_noisy");
  int skipping = 0;
  for (std::size_t i = 0; i < timings.stageCount; ++i) {
    REQUIRE(quellGetStageTimings(c.denoiser.get(), i, &stage) == QUELL_SUCCESS);
    skipping += stage.hasSkippedShare;
    CHECK((stage.skippedShare >= 0.0 && stage.skippedShare <= 1.0));
  }
  CHECK(skipping > 0);
  checkError(quellGetStageTimings(c.denoiser.get(), timings.stageCount, &stage), QUELL_INVALID_ARGUMENT,
             "index");
  REQUIRE(quellClearTimings(c.denoiser.get()) == QUELL_SUCCESS);
  REQUIRE(quellGetTimings(c.denoiser.get(), &timings) == QUELL_SUCCESS);
  CHECK(timings.frame.count == 0);
}

TEST_CASE("settings go both ways through the C API", "[core][c]") {
  const SettingsHandle handle("svgf");
  quell_settings* settings = handle.settings;
  CHECK(quellSetSetting(settings, "taa", "off") == QUELL_SUCCESS);
  CHECK(quellSetSettingNumber(settings, "iterations", 3.0) == QUELL_SUCCESS);
  CHECK(handle.text("taa") == "off");
  CHECK(handle.text("iterations") == "3");
  double number = 0.0;
  CHECK(quellGetSettingNumber(settings, "iterations", &number) == QUELL_SUCCESS);
  CHECK(number == 3.0);
  checkError(quellSetSetting(settings, "nothing", "1"), QUELL_UNKNOWN_SETTING, "nothing");
  checkError(quellSetSettingNumber(settings, "iterations", -1.0), QUELL_OUT_OF_RANGE, "iterations");
  CHECK(handle.text("iterations") == "3");

  Settings paper("svgf");
  paper.usePreset("paper");
  CHECK(quellUsePreset(settings, "default") == QUELL_SUCCESS);
  CHECK(quellUsePreset(settings, "paper") == QUELL_SUCCESS);
  CHECK(handle.text("luminanceSigma") == paper.text("luminanceSigma"));
  checkError(quellUsePreset(settings, "magic"), QUELL_UNKNOWN_SETTING, "preset");

  OpenDevice device;
  quell_denoiser* made = nullptr;
  REQUIRE(quellCreateDenoiser(device.context(), device.device(), device.queue(), settings, nullptr, &made) ==
          QUELL_SUCCESS);
  const DenoiserHandle denoiser(made);
  SettingsHandle copy;
  quellDestroySettings(copy.settings);
  REQUIRE(quellGetDenoiserSettings(made, &copy.settings) == QUELL_SUCCESS);
  const char* method = nullptr;
  REQUIRE(quellGetSettingsMethod(copy.settings, &method) == QUELL_SUCCESS);
  CHECK(std::string(method) == "svgf");
  CHECK(copy.text("luminanceSigma") == paper.text("luminanceSigma"));
}

TEST_CASE("all methods and settings are described", "[core][c]") {
  std::size_t count = 0;
  REQUIRE(quellCountMethods(&count) == QUELL_SUCCESS);
  REQUIRE(count == methodNames().size());
  for (std::size_t m = 0; m < count; ++m) {
    quell_method_info method;
    QUELL_INIT(method);
    REQUIRE(quellGetMethod(m, &method) == QUELL_SUCCESS);
    CHECK(method.name == methodNames()[m]);
    CHECK(method.summary == methodSummary(method.name));
    const std::vector<SettingDescription>& expected = methodSettings(method.name);
    REQUIRE(method.settingCount == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      quell_setting_info info;
      QUELL_INIT(info);
      REQUIRE(quellGetSettingInfo(method.name, i, &info) == QUELL_SUCCESS);
      CHECK(info.name == expected[i].name);
      CHECK(info.kind == static_cast<quell_setting_kind>(expected[i].kind));
      CHECK(info.defaultValue == expected[i].defaultValue);
      CHECK(info.minimum == expected[i].minimum);
      CHECK(info.maximum == expected[i].maximum);
      CHECK(info.unit == expected[i].unit);
      CHECK(info.description == expected[i].description);
      CHECK(info.source == expected[i].source);
      CHECK(info.defaultText == expected[i].defaultText);
      CHECK((info.hasPaperValue != 0) == expected[i].paper.has_value());
      CHECK(info.paperValue == expected[i].paper.value_or(0.0));
      REQUIRE(info.choiceCount == expected[i].choices.size());
      for (std::size_t c = 0; c < info.choiceCount; ++c) {
        const char* choice = nullptr;
        REQUIRE(quellGetSettingChoice(method.name, i, c, &choice) == QUELL_SUCCESS);
        CHECK(choice == expected[i].choices[c]);
      }
    }
  }
}

TEST_CASE("devices are listed and chosen through the C API", "[core][c]") {
  const std::vector<DeviceInfo> expected = listDevices();
  std::size_t count = 0;
  REQUIRE(quellCountDevices(&count) == QUELL_SUCCESS);
  REQUIRE(count == expected.size());
  quell_device_info info;
  QUELL_INIT(info);
  for (std::size_t i = 0; i < count; ++i) {
    REQUIRE(quellGetDevice(i, &info) == QUELL_SUCCESS);
    CHECK(info.device == expected[i].device);
    CHECK(info.name == expected[i].name);
    CHECK(info.type == expected[i].type);
    CHECK(info.maxWorkGroup == expected[i].maxWorkGroup);
  }
  REQUIRE(quellChooseDevice(nullptr, &info) == QUELL_SUCCESS);
  CHECK(info.device == chooseDevice().device);
  checkError(quellGetDevice(count, &info), QUELL_INVALID_ARGUMENT, "index");
  checkError(quellChooseDevice("no such device", &info), QUELL_NO_DEVICE, "no such device");
}

}  // namespace quell::tests
