// Which images a method reads: asked of its stages, with every image there and with one of them missing.
#include <algorithm>
#include <quell/denoiser.hpp>
#include <quell/error.hpp>
#include <string>

#include "host/core/frame_images.hpp"
#include "host/core/image_schema.hpp"
#include "host/core/imported_images.hpp"
#include "host/core/stage.hpp"
#include "host/methods/method.hpp"

namespace quell {
namespace {

/// Images of floats of any size with all channels; view depth stands back for positions.
Configuration fullConfiguration(const Settings& settings, const Method& method) {
  Configuration configuration;
  configuration.settings = settings;
  configuration.runtime = method.runtimeSettings(settings);
  configuration.frame.size = {64, 64};
  for (const auto& image : kInputs<Frame>)
    configuration.frame.*image.member = packedImage(nullptr, image.mostChannels);
  configuration.frame.viewDepth = {};
  configuration.output.linear = configuration.output.display = packedImage(nullptr, 3);
  return configuration;
}

Schedule scheduleOf(const Method& method, const Configuration& configuration) {
  requireFBetaImages(configuration);
  return method.makeSchedule(configuration);
}

bool worksWithout(const Method& method, Configuration configuration, ImageView Frame::*input) {
  configuration.frame.*input = {};
  try {
    scheduleOf(method, configuration);
    return true;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidArgument) throw;
    return false;
  }
}

/// Without the marks of a table in a document.
std::string plainText(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
  return text;
}

}  // namespace

std::vector<InputNeed> inputNeeds(const Settings& settings) {
  const Method& method = findMethod(settings.method());
  const Configuration configuration = fullConfiguration(settings, method);
  const Schedule schedule = scheduleOf(method, configuration);
  std::vector<InputNeed> needs;
  for (const auto& image : kInputs<Frame>) {
    InputNeed need{image.name, InputUse::Unused, plainText(image.texts.absent)};
    const bool isPlace = image.member == &Frame::positionWorld || image.member == &Frame::viewDepth;
    if (image.required() || isPlace || !worksWithout(method, configuration, image.member))
      need.use = InputUse::Required;
    else if (readsImage(schedule, configuration, image.member))
      need.use = InputUse::Optional;
    needs.push_back(need);
  }
  return needs;
}

}  // namespace quell
