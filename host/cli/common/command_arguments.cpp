#include "host/cli/common/command_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "host/core/device_traits.hpp"

namespace quell::cli {

void refuse(const char* command, const std::string& option, const std::string& expected,
            const std::string& got) {
  throw Error(ErrorCode::InvalidArgument, {command, option, expected, got});
}

bool isRefusal(const Error& error) {
  return error.code() == ErrorCode::InvalidArgument || error.code() == ErrorCode::OutOfRange;
}

std::pair<int, int> parsePair(const char* command, const char* option, const std::string& text,
                              char separator, const char* expected) {
  const std::size_t split = text.find(separator);
  try {
    std::size_t used = 0;
    const int first = std::stoi(text.substr(0, split), &used);
    if (used != (split == std::string::npos ? text.size() : split)) refuse(command, option, expected, text);
    if (split == std::string::npos) return {first, first};
    const int second = std::stoi(text.substr(split + 1), &used);
    if (used != text.size() - split - 1) refuse(command, option, expected, text);
    return {first, second};
  } catch (const std::logic_error&) {
    refuse(command, option, expected, text);
  }
}

std::pair<int, int> parseFrameRange(const char* command, const std::string& text) {
  const bool colon = text.find(':') != std::string::npos || text.find('-') == 0;
  return parsePair(command, "--frames", text, colon ? ':' : '-', "a range such as 0-15 or -2:1");
}

std::string frameRangeText(int first, int last) {
  return fmt::format("{}{}{}", first, first < 0 ? ':' : '-', last);
}

Size parseSize(const char* command, const std::string& text) {
  const auto [width, height] = parsePair(command, "--size", text, 'x', "a size such as 1280x720");
  return {width, height};
}

std::pair<std::string, std::string> parseAssignment(const char* command, const char* option,
                                                    const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse(command, option, "name=value", text);
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<std::string> mappingNames() {
  std::vector<std::string> names;
  for (const MappingFacts& facts : kMappings) names.emplace_back(facts.name);
  return names;
}

void addDeviceArguments(CLI::App& command, DeviceArguments& arguments) {
  command.add_option("--device", arguments.device, "Index or part of a name, see 'quell devices'");
  command
      .add_option(
          "--mapping", arguments.mapping,
          "Pixels per work-item: 1 (narrow), as many as fill a vector of the device (wide), 4, 8 or 16 "
          "(wide4, wide8, wide16), or what suits the device")
      ->check(CLI::IsMember(mappingNames()))
      ->capture_default_str();
  command.add_option("--cache-directory", arguments.cacheDirectory, "Where compiled kernels are kept");
  command.add_flag("--no-cache", arguments.noCache, "Keep no compiled kernels on disk");
}

Options makeOptions(const DeviceArguments& arguments, TimerMode timers) {
  Options result;
  result.timers = timers;
  result.mapping = mappingNamed(arguments.mapping)->mapping;  // the option takes no other names
  if (arguments.noCache) {
    result.cacheDirectory = "";
  } else if (!arguments.cacheDirectory.empty()) {
    result.cacheDirectory = arguments.cacheDirectory;
  }
  return result;
}

void addMethodArguments(CLI::App& command, MethodArguments& arguments) {
  command.add_option("--method", arguments.method, "Method")
      ->check(CLI::IsMember(methodNames()))
      ->capture_default_str();
  command.add_option("--taa", arguments.taa, "Temporal antialiasing of the display image")
      ->check(CLI::IsMember({"on", "off"}));
  command.add_flag("--no-skip", arguments.noSkip, "Leave no background out, short for --set skip=off");
  command.add_option("--demodulate", arguments.demodulate, "Short for --set demodulate=...");
  command.add_option("--preset", arguments.preset, "Settings to start from: default, or those of the paper")
      ->check(CLI::IsMember({"default", "paper"}))
      ->capture_default_str();
  command.add_option("--features", arguments.features, "Features of the fit, short for --set features=...");
  command.add_option("--set", arguments.settings, "A setting of the method, name=value; may be repeated");
}

Settings applyMethodArguments(const char* command, const MethodArguments& arguments, Settings settings) {
  if (arguments.preset != "default") settings.usePreset(arguments.preset);
  if (!arguments.taa.empty()) settings.set("taa", arguments.taa);
  if (arguments.noSkip) settings.set("skip", "off");
  if (!arguments.demodulate.empty()) settings.set("demodulate", arguments.demodulate);
  if (!arguments.features.empty()) settings.set("features", arguments.features);
  for (const std::string& assignment : arguments.settings) {
    const auto [name, value] = parseAssignment(command, "--set", assignment);
    settings.set(name, value);
  }
  return settings;
}

void addMotionOption(CLI::App& command, std::string& motion) {
  command
      .add_option("--motion", motion, "Motion vectors and object ids: auto, used where there are any, or off")
      ->check(CLI::IsMember({"auto", "off"}))
      ->capture_default_str();
}

MotionUse motionUse(const std::string& motion) {
  return motion == "off" ? MotionUse::Never : MotionUse::WherePresent;
}

bool hasSetting(const std::string& method, const std::string& setting) {
  const std::vector<SettingDescription>& all = methodSettings(method);
  return std::any_of(all.begin(), all.end(),
                     [&](const SettingDescription& description) { return description.name == setting; });
}

Settings defaultSettings(const std::string& method, const io::FrameSequence& sequence) {
  Settings settings(method);
  if (hasSetting(method, "jitteredRays") && sequence.jittered()) settings.set("jitteredRays", "on");
  const std::optional<io::HistoryLimits> limits = sequence.historyLimits();
  if (!limits) return settings;
  // Published with the sequence, so better than any default.
  if (hasSetting(method, "positionLimit")) settings.set("positionLimit", std::sqrt(limits->positionSquared));
  if (hasSetting(method, "normalLimitSquared")) settings.set("normalLimitSquared", limits->normalSquared);
  return settings;
}

std::string settingRange(const SettingDescription& setting) {
  if (setting.kind == SettingKind::Text) return "";
  std::string range = fmt::format("{:g} to {:g}", setting.minimum, setting.maximum);
  if (setting.kind == SettingKind::Boolean) range = "on, off";
  if (setting.kind == SettingKind::Choice) range = fmt::format("{}", fmt::join(setting.choices, ", "));
  return setting.unit.empty() ? range : range + " " + setting.unit;
}

std::string settingsHelp(const std::string& option) {
  std::string text = fmt::format("Settings for {}:\n", option);
  for (const std::string& method : methodNames()) {
    text += fmt::format("  {}: {}\n", method, methodSummary(method));
    const Settings defaults(method);
    for (const SettingDescription& setting : methodSettings(method)) {
      const std::string range = settingRange(setting);
      text += fmt::format("    {:<24} {} (default {}{}{})\n", setting.name, setting.description,
                          defaults.text(setting.name), range.empty() ? "" : "; ", range);
    }
  }
  return text;
}

}  // namespace quell::cli
