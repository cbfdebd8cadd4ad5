// Arguments that several commands take, and how their text is read.
#pragma once

#include <CLI/App.hpp>
#include <quell/quell.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/cli/common/denoise_session.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// Throws Error(InvalidArgument) that names the command and the option.
[[noreturn]] void refuse(const char* command, const std::string& option, const std::string& expected,
                         const std::string& got);

/// Whether the library refused what it was asked for, rather than failed at it.
bool isRefusal(const Error& error);

/// "A<separator>B" as two whole numbers; a single number stands for both. Throws Error(InvalidArgument).
std::pair<int, int> parsePair(const char* command, const char* option, const std::string& text,
                              char separator, const char* expected);

/// "A-B" as the frames of --frames, or "A:B" where one of them is negative; a single number stands for both. Throws
/// Error(InvalidArgument).
std::pair<int, int> parseFrameRange(const char* command, const std::string& text);
/// The same as text.
std::string frameRangeText(int first, int last);

/// "1280x720". Only the form is checked, not the range. Throws Error(InvalidArgument).
Size parseSize(const char* command, const std::string& text);

/// "name=value" as its two parts, split at the first "=". Throws Error(InvalidArgument).
std::pair<std::string, std::string> parseAssignment(const char* command, const char* option,
                                                    const std::string& text);

/// Where and how denoisers run: --device, --mapping, --cache-directory and --no-cache.
struct DeviceArguments {
  std::string device;  ///< as for chooseDevice()
  std::string mapping = "automatic";
  std::string cacheDirectory;  ///< empty: the library's default
  bool noCache = false;
};

/// `arguments` must live as long as `command`.
void addDeviceArguments(CLI::App& command, DeviceArguments& arguments);
Options makeOptions(const DeviceArguments& arguments, TimerMode timers);

/// Which method runs with which settings: --method, --preset, --taa, --demodulate, --features and --set.
struct MethodArguments {
  std::string method = Settings().method();
  std::string preset = "default";
  std::string taa;
  bool noSkip = false;
  std::string demodulate;
  std::string features;
  std::vector<std::string> settings;  ///< name=value
};

/// `arguments` must live as long as `command`.
void addMethodArguments(CLI::App& command, MethodArguments& arguments);
/// `settings` with what the arguments say on top. Throws what Settings throws, and Error(InvalidArgument).
Settings applyMethodArguments(const char* command, const MethodArguments& arguments, Settings settings);

/// --motion: auto, or off. `motion` must live as long as `command`.
void addMotionOption(CLI::App& command, std::string& motion);
MotionUse motionUse(const std::string& motion);

/// True if the method has a setting of this name. Throws Error(UnknownSetting) for an unknown method.
bool hasSetting(const std::string& method, const std::string& setting);

/// The method's defaults, with the history limits published with the sequence where the method knows them.
Settings defaultSettings(const std::string& method, const io::FrameSequence& sequence);

/// What a setting may be, with its unit: "1 to 255 frames", "on, off"; empty for texts.
std::string settingRange(const SettingDescription& setting);

/// All methods and their settings with ranges and defaults, for --help; `option` is what sets them.
std::string settingsHelp(const std::string& option);

}  // namespace quell::cli
