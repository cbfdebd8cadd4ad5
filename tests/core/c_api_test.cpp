// The C API: the same denoiser, errors as status and text, structs of other versions.
#include <quell/quell.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kLastFrame = 2;

struct DestroyDenoiser {
  void operator()(quell_denoiser* denoiser) const { quellDestroyDenoiser(denoiser); }
};
using DenoiserHandle = std::unique_ptr<quell_denoiser, DestroyDenoiser>;

quell_component_format toC(ComponentFormat format) {
  if (format == ComponentFormat::UInt32) return QUELL_UINT32;
  return format == ComponentFormat::Float32 ? QUELL_FLOAT32 : QUELL_FLOAT16;
}

quell_image_view toC(const ImageView& view) {
  quell_image_view result = quellPackedImage(view.memory, view.channels, toC(view.format));
  result.offsetBytes = view.offsetBytes;
  result.pixelStrideBytes = view.pixelStrideBytes;
  result.rowPitchBytes = view.rowPitchBytes;
  return result;
}

quell_frame toC(const Frame& frame) {
  quell_frame result;
  QUELL_INIT(result);
  result.width = frame.size.width;
  result.height = frame.size.height;
  std::memcpy(result.camera.worldToClip, frame.camera.worldToClip.data(), sizeof(Matrix4));
  std::memcpy(result.camera.worldToClipPrev, frame.camera.worldToClipPrev.data(), sizeof(Matrix4));
  std::memcpy(result.camera.jitterPx, frame.camera.jitterPx.data(), sizeof(result.camera.jitterPx));
  std::memcpy(result.camera.jitterPxPrev, frame.camera.jitterPxPrev.data(),
              sizeof(result.camera.jitterPxPrev));
  forEachInput(frame, result,
               [](const ImageFacts&, const ImageView& view, quell_image_view& given) { given = toC(view); });
  return result;
}

quell_output toC(const Output& output) {
  quell_output result;
  QUELL_INIT(result);
  result.linear = toC(output.linear);
  result.display = toC(output.display);
  return result;
}

/// A device with buffers, and a denoiser of the C API that is prepared for them.
struct CDenoiser {
  explicit CDenoiser(const ImageSetup& setup = {}, cl_command_queue_properties properties = 0,
                     quell_timer_mode timers = QUELL_TIMERS_OFF)
      : device(properties), buffers(device, setup) {
    quell_options options;
    QUELL_INIT(options);
    options.timers = timers;
    options.cacheDirectory = "";
    quell_denoiser* made = nullptr;
    REQUIRE(quellCreateDenoiser(device.context(), device.device(), device.queue(), nullptr, &options,
                                &made) == QUELL_SUCCESS);
    denoiser.reset(made);
    const quell_frame frame = toC(buffers.frame);
    const quell_output output = toC(buffers.output);
    REQUIRE(quellPrepare(denoiser.get(), &frame, &output) == QUELL_SUCCESS);
  }

  Picture run(int first, int last) {
    for (int number = first; number <= last; ++number) {
      buffers.upload(number);
      const quell_frame frame = toC(buffers.frame);
      const quell_output output = toC(buffers.output);
      cl_event done = nullptr;
      REQUIRE(quellDenoise(denoiser.get(), &frame, &output, 0, nullptr, &done) == QUELL_SUCCESS);
      Event(done).wait();
    }
    return buffers.download();
  }

  OpenDevice device;
  FrameBuffers buffers;
  DenoiserHandle denoiser;
};

struct SettingsHandle {
  explicit SettingsHandle(const char* method = nullptr) {
    REQUIRE(quellCreateSettings(method, &settings) == QUELL_SUCCESS);
  }
  SettingsHandle(const SettingsHandle&) = delete;
  SettingsHandle& operator=(const SettingsHandle&) = delete;
  ~SettingsHandle() { quellDestroySettings(settings); }
  std::string text(const char* name) const {
    const char* value = nullptr;
    REQUIRE(quellGetSetting(settings, name, &value) == QUELL_SUCCESS);
    return value;
  }
  quell_settings* settings = nullptr;
};

/// The last error must have this status and argument.
void checkError(quell_status returned, quell_status status, const std::string& argument) {
  quell_error error;
  QUELL_INIT(error);
  REQUIRE(quellGetLastError(&error) == QUELL_SUCCESS);
  INFO(error.message);
  CHECK(returned == status);
  CHECK(error.status == status);
  CHECK(error.buffer == argument);
  CHECK(std::string(error.message) == quellErrorMessage());
  CHECK_THAT(error.message, Catch::Contains(quellStatusName(status)) && Catch::Contains(error.expected) &&
                                Catch::Contains(error.got) && Catch::Contains(error.stage));
}

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

TEST_CASE("NULL is refused by name everywhere", "[core][c]") {
  const auto refused = [](quell_status status, const char* argument) {
    checkError(status, QUELL_INVALID_ARGUMENT, argument);
  };
  refused(quellCountDevices(nullptr), "count");
  refused(quellGetDevice(0, nullptr), "info");
  refused(quellChooseDevice(nullptr, nullptr), "info");
  refused(quellCountMethods(nullptr), "count");
  refused(quellGetMethod(0, nullptr), "info");
  refused(quellGetSettingInfo(nullptr, 0, nullptr), "method");
  refused(quellGetSettingInfo("svgf", 0, nullptr), "info");
  refused(quellGetSettingChoice(nullptr, 0, 0, nullptr), "method");
  refused(quellCreateSettings(nullptr, nullptr), "settings");
  refused(quellSetSetting(nullptr, "taa", "on"), "settings");
  refused(quellSetSettingNumber(nullptr, "taa", 1.0), "settings");
  refused(quellUsePreset(nullptr, "paper"), "settings");
  refused(quellGetSetting(nullptr, "taa", nullptr), "settings");
  refused(quellGetSettingNumber(nullptr, "taa", nullptr), "settings");
  refused(quellGetSettingsMethod(nullptr, nullptr), "settings");
  refused(quellCreateDenoiser(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr), "denoiser");
  refused(quellPrepare(nullptr, nullptr, nullptr), "denoiser");
  refused(quellDenoise(nullptr, nullptr, nullptr, 0, nullptr, nullptr), "denoiser");
  refused(quellResetHistory(nullptr), "denoiser");
  refused(quellGetDenoiserSettings(nullptr, nullptr), "denoiser");
  refused(quellGetMemoryUse(nullptr, nullptr), "denoiser");
  refused(quellGetBufferUse(nullptr, 0, nullptr), "denoiser");
  refused(quellGetTimings(nullptr, nullptr), "denoiser");
  refused(quellGetStageTimings(nullptr, 0, nullptr), "denoiser");
  refused(quellClearTimings(nullptr), "denoiser");
  refused(quellGetLastError(nullptr), "error");
  quellDestroySettings(nullptr);
  quellDestroyDenoiser(nullptr);

  const SettingsHandle handle;
  refused(quellSetSetting(handle.settings, nullptr, "on"), "name");
  refused(quellSetSetting(handle.settings, "taa", nullptr), "value");
  refused(quellSetSettingNumber(handle.settings, nullptr, 1.0), "name");
  refused(quellUsePreset(handle.settings, nullptr), "preset");
  refused(quellGetSetting(handle.settings, nullptr, nullptr), "name");
  refused(quellGetSetting(handle.settings, "taa", nullptr), "value");
  refused(quellGetSettingNumber(handle.settings, nullptr, nullptr), "name");
  refused(quellGetSettingNumber(handle.settings, "taa", nullptr), "value");
  refused(quellGetSettingsMethod(handle.settings, nullptr), "method");

  OpenDevice device;
  quell_denoiser* made = nullptr;
  refused(quellCreateDenoiser(nullptr, device.device(), device.queue(), nullptr, nullptr, &made), "context");
  REQUIRE(quellCreateDenoiser(device.context(), device.device(), device.queue(), nullptr, nullptr, &made) ==
          QUELL_SUCCESS);
  const DenoiserHandle denoiser(made);
  quell_frame frame;
  QUELL_INIT(frame);
  quell_output output;
  QUELL_INIT(output);
  refused(quellPrepare(made, nullptr, &output), "frame");
  refused(quellPrepare(made, &frame, nullptr), "output");
  refused(quellDenoise(made, &frame, &output, 1, nullptr, nullptr), "waitList");
  refused(quellGetMemoryUse(made, nullptr), "use");
  refused(quellGetTimings(made, nullptr), "timings");
  refused(quellGetDenoiserSettings(made, nullptr), "settings");
}

TEST_CASE("refusals of the denoiser come as status and text", "[core][c]") {
  CDenoiser c;
  quell_frame frame = toC(c.buffers.frame);
  const quell_output output = toC(c.buffers.output);
  const auto denoise = [&] { return quellDenoise(c.denoiser.get(), &frame, &output, 0, nullptr, nullptr); };
  frame.width += 1;
  CHECK(denoise() == QUELL_NOT_PREPARED);
  frame = toC(c.buffers.frame);
  frame.normalWorld.memory = nullptr;
  checkError(denoise(), QUELL_INVALID_ARGUMENT, "normalWorld");
  frame = toC(c.buffers.frame);
  frame.albedo.format = 7;
  checkError(denoise(), QUELL_INVALID_ARGUMENT, "albedo.format");
  const OpenDevice other;
  const cl::Buffer foreign(other.context, CL_MEM_READ_WRITE, 1 << 16);
  frame = toC(c.buffers.frame);
  frame.albedo.memory = foreign();
  checkError(denoise(), QUELL_WRONG_CONTEXT, "albedo");

  quell_options options;
  QUELL_INIT(options);
  options.mapping = 9;
  quell_denoiser* made = nullptr;
  const auto create = [&] {
    return quellCreateDenoiser(c.device.context(), c.device.device(), c.device.queue(), nullptr, &options,
                               &made);
  };
  checkError(create(), QUELL_INVALID_ARGUMENT, "options.mapping");
  QUELL_INIT(options);
  options.timers = -1;
  checkError(create(), QUELL_INVALID_ARGUMENT, "options.timers");
  QUELL_INIT(options);
  options.fitGroup = 3;
  checkError(create(), QUELL_INVALID_ARGUMENT, "options.fitGroup");
  CHECK(made == nullptr);
}

TEST_CASE("structs of other versions of the header", "[core][c]") {
  OpenDevice device;
  quell_denoiser* made = nullptr;
  const auto create = [&](const quell_options* options) {
    return quellCreateDenoiser(device.context(), device.device(), device.queue(), nullptr, options, &made);
  };
  struct {
    quell_options known;
    unsigned char added[32];
  } newer;
  std::memset(&newer, 0, sizeof(newer));
  newer.known.structSize = sizeof(newer);
  CHECK(create(&newer.known) == QUELL_SUCCESS);
  quellDestroyDenoiser(made);
  newer.added[31] = 1;
  checkError(create(&newer.known), QUELL_INVALID_ARGUMENT, "options.structSize");
  quell_options forgotten{};
  checkError(create(&forgotten), QUELL_INVALID_ARGUMENT, "options.structSize");

  struct {
    quell_method_info known;
    unsigned char added[32];
  } result;
  std::memset(&result, 0x55, sizeof(result));
  result.known.structSize = sizeof(result);
  CHECK(quellGetMethod(0, &result.known) == QUELL_SUCCESS);
  CHECK(result.known.structSize == sizeof(result));
  for (const unsigned char byte : result.added) CHECK(byte == 0x55);
  result.known.structSize = 4;
  checkError(quellGetMethod(0, &result.known), QUELL_INVALID_ARGUMENT, "info.structSize");
}

TEST_CASE("every error code has a status of the same name", "[core][c]") {
  for (int code = 0; code <= static_cast<int>(ErrorCode::FileError); ++code)
    CHECK(std::string(quellStatusName(code + 1)) == toString(static_cast<ErrorCode>(code)));
  CHECK(std::string(quellStatusName(QUELL_SUCCESS)) == "Success");
  CHECK(std::string(quellStatusName(QUELL_INTERNAL_ERROR)) == "InternalError");
  CHECK(std::string(quellStatusName(-5)) == "Unknown");
}

TEST_CASE("the last error belongs to its thread", "[core][c]") {
  checkError(quellCountMethods(nullptr), QUELL_INVALID_ARGUMENT, "count");
  const std::string before = quellErrorMessage();
  std::thread([] {
    CHECK(std::string(quellErrorMessage()).empty());
    quellUsePreset(nullptr, "paper");
    CHECK_FALSE(std::string(quellErrorMessage()).empty());
  }).join();
  std::size_t count = 0;
  CHECK(quellCountMethods(&count) == QUELL_SUCCESS);
  CHECK(before == quellErrorMessage());
}

}  // namespace quell::tests
