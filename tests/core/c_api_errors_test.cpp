// Errors of the C API as status and text, and structs of other versions.
#include <catch2/catch.hpp>
#include <cstring>
#include <string>
#include <thread>

#include "tests/core/c_denoiser.hpp"

namespace quell::tests {
namespace {

void refused(quell_status status, const char* argument) {
  checkError(status, QUELL_INVALID_ARGUMENT, argument);
}

}  // namespace

TEST_CASE("NULL is refused by name everywhere", "[core][c]") {
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
  refused(quellReadBuffer(nullptr, nullptr, nullptr, 0, nullptr), "denoiser");
  refused(quellResetHistory(nullptr), "denoiser");
  refused(quellCheckFrame(nullptr, nullptr, 0, nullptr, nullptr), "denoiser");
  refused(quellGetFinding(nullptr, 0, nullptr), "denoiser");
  refused(quellGetCheckFigure(nullptr, 0, nullptr), "denoiser");
  refused(quellGetDenoiserSettings(nullptr, nullptr), "denoiser");
  refused(quellGetMemoryUse(nullptr, nullptr), "denoiser");
  refused(quellGetBufferUse(nullptr, 0, nullptr), "denoiser");
  refused(quellGetTimings(nullptr, nullptr), "denoiser");
  refused(quellGetStageTimings(nullptr, 0, nullptr), "denoiser");
  refused(quellClearTimings(nullptr), "denoiser");
  refused(quellGetLastError(nullptr), "error");
  quellDestroySettings(nullptr);
  quellDestroyDenoiser(nullptr);
}

TEST_CASE("NULL beside a handle is refused by name", "[core][c]") {
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
  refused(quellCheckFrame(made, nullptr, 0, nullptr, nullptr), "frame");
  refused(quellCheckFrame(made, &frame, 1, nullptr, nullptr), "waitList");
  quell_finding finding;
  QUELL_INIT(finding);
  refused(quellGetFinding(made, 0, &finding), "index");
  refused(quellReadBuffer(made, nullptr, nullptr, 0, nullptr), "name");
  refused(quellReadBuffer(made, "beforeAntialiasing", nullptr, 1, nullptr), "values");
  refused(quellReadBuffer(made, "beforeAntialiasing", nullptr, 0, nullptr), "content");
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
  quell_options older;
  QUELL_INIT(older);
  older.structSize = offsetof(quell_options, keptBuffers);
  older.keptBuffers = reinterpret_cast<const char*>(1);  // nothing of this program's
  CHECK(create(&older) == QUELL_SUCCESS);
  quellDestroyDenoiser(made);
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
