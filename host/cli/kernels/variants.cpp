#include "host/cli/kernels/variants.hpp"

#include <algorithm>
#include <quell/quell.hpp>
#include <vector>

#include "host/cli/common/command_arguments.hpp"
#include "host/cli/kernels/kernel_list.hpp"
#include "host/core/image_schema.hpp"

namespace quell::cli {
namespace {

// No option depends on it.
constexpr Size kSize{1280, 720};

ImageView imageOf(int channels, ComponentFormat format) {
  ImageView view;
  view.format = format;
  view.channels = channels;
  return view;
}

// A frame with every image that there is, save that position comes from one of two.
Frame fullFrame(ComponentFormat format, int mostChannels, int signals) {
  Frame frame;
  frame.size = kSize;
  for (const auto& image : kInputs<Frame>)
    frame.*image.member = imageOf(std::min(image.mostChannels, mostChannels), format);
  frame.viewDepth = {};
  if (signals == 1) frame.glossyRadiance = {};
  return frame;
}

Frame leastFrame() {
  Frame frame;
  frame.size = kSize;
  for (const auto& image : kInputs<Frame>)
    if (image.required()) frame.*image.member = imageOf(3, ComponentFormat::Float32);
  frame.viewDepth = imageOf(1, ComponentFormat::Float32);
  return frame;
}

std::vector<Frame> makeFrames(ImageSets images) {
  std::vector<Frame> frames = {fullFrame(ComponentFormat::Float32, 3, 1),
                               fullFrame(ComponentFormat::Float32, 3, 2)};
  if (images == ImageSets::All) {
    frames.push_back(fullFrame(ComponentFormat::Float16, 4, 1));
    frames.push_back(fullFrame(ComponentFormat::Float16, 4, 2));
    frames.push_back(leastFrame());
  }
  return frames;
}

std::vector<std::string> valuesOf(const SettingDescription& setting) {
  if (setting.kind == SettingKind::Choice) return setting.choices;
  if (setting.kind == SettingKind::Boolean) return {"on", "off"};
  return {};
}

/// What a stage does with it does not depend on other settings: its values meet only the defaults, and each other in turn.
bool standsAlone(const SettingDescription& setting) {
  return setting.name == "toneMap" || setting.name == "displayEncoding" || setting.name == "antialiasLinear";
}

std::vector<Settings> allChoices(const std::string& method, const std::string& features) {
  std::vector<Settings> all = {Settings(method)};
  if (!features.empty() && hasSetting(method, "features")) all[0].set("features", features);
  const Settings usual = all[0];
  for (const SettingDescription& setting : methodSettings(method)) {
    if (standsAlone(setting)) continue;
    std::vector<Settings> varied;
    for (const std::string& value : valuesOf(setting)) {
      for (Settings settings : all) {
        settings.set(setting.name, value);
        varied.push_back(std::move(settings));
      }
    }
    if (!varied.empty()) all = std::move(varied);
  }
  std::size_t most = 0;
  for (const SettingDescription& setting : methodSettings(method))
    if (standsAlone(setting)) most = std::max(most, valuesOf(setting).size());
  for (std::size_t i = 0; i < most; ++i) {
    all.push_back(usual);
    for (const SettingDescription& setting : methodSettings(method)) {
      const std::vector<std::string> values = valuesOf(setting);
      if (standsAlone(setting)) all.back().set(setting.name, values[i % values.size()]);
    }
  }
  return all;
}

void addConfiguration(KernelVariants& variants, const Configuration& configuration) {
  try {
    for (const KernelUse& use : listKernels(configuration))
      variants[{use.stem, use.options}].insert(configuration.settings.method());
  } catch (const Error& error) {
    if (!isRefusal(error)) throw;
  }
}

}  // namespace

void addKernelVariants(KernelVariants& variants, const std::string& method, ImageSets images, int lanes,
                       std::size_t maxWorkGroup, const std::string& features) {
  DeviceTraits device;
  device.isCpu = lanes > 1;
  device.lanes = lanes;
  device.maxWorkGroup = maxWorkGroup;
  for (const Frame& frame : makeFrames(images)) {
    Output output;
    output.linear = output.display = frame.radiance;
    for (const Settings& settings : allChoices(method, features))
      addConfiguration(variants, {device, {}, settings, frame, output});
  }
}

}  // namespace quell::cli
