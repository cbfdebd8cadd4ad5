#include "host/cli/common/sequence_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/cli/common/command_arguments.hpp"

namespace quell::cli {
namespace {

/// What --missing takes.
constexpr char kRefuse[] = "error", kSkip[] = "skip";

void addMissingOption(CLI::App& command, io::MissingFrames& missing) {
  command
      .add_option_function<std::string>(
          "--missing",
          [&missing](const std::string& text) {
            missing = text == kSkip ? io::MissingFrames::Skip : io::MissingFrames::Refuse;
          },
          "Frames missing in between: error, or skip, which goes on after a gap as after a cut")
      ->check(CLI::IsMember(std::vector<std::string>{kRefuse, kSkip}))
      ->default_str(kRefuse);
}

}  // namespace

void addSignalsOption(CLI::App& command, int& signals) {
  command.add_option("--signals", signals, "1, or 2: diffuse and glossy light side by side")
      ->check(CLI::Range(1, 2))
      ->capture_default_str();
}

void addSequenceOptions(CLI::App& command, io::SequenceOptions& options) {
  io::ChannelOptions& channels = options.channels;
  std::vector<std::string> images, renderers = io::rendererNames();
  for (const io::NamedImage& image : io::namedImages()) images.emplace_back(image.name);
  renderers.insert(renderers.begin(), channels.renderer);
  command
      .add_option("--channels", channels.channels,
                  fmt::format("Channels of an image where no renderer's names fit: color=R,G,B normal=N "
                              "depth=dist:ray motion=MV:uv/y-up emission=Emit+Env; images are {}",
                              fmt::join(images, ", ")))
      ->type_name("IMAGE=NAME");
  command
      .add_option("--renderer", channels.renderer,
                  "Whose names of channels (Blender's are those of cycles); auto: those that explain most")
      ->transform([](const std::string& name) { return name == "blender" ? std::string("cycles") : name; })
      ->check(CLI::IsMember(renderers))
      ->capture_default_str();
  command.add_option("--layer", channels.layer, "View layer, or what stands before the passes' names")
      ->type_name("NAME");
  command.add_option("--view", channels.view, "View of stereo pictures, such as left")->type_name("NAME");
  addMissingOption(command, options.missing);
}

std::vector<int> chooseFrames(const char* command, std::vector<int> frames, const std::string& range) {
  if (range.empty()) return frames;
  const auto [first, last] = parseFrameRange(command, range);
  const std::string present = fmt::format("a range within {}", frameRangeText(frames.front(), frames.back()));
  if (first > last || first < frames.front() || last > frames.back())
    refuse(command, "--frames", present, range);
  frames.erase(
      std::remove_if(frames.begin(), frames.end(), [a = first, b = last](int f) { return f < a || f > b; }),
      frames.end());
  if (frames.empty()) refuse(command, "--frames", "frames that are not missing", range);
  return frames;
}

std::vector<int> prerollFrames(const std::vector<int>& frames, int first, int count) {
  const auto end = std::lower_bound(frames.begin(), frames.end(), first);
  return {end - std::min<std::ptrdiff_t>(count, end - frames.begin()), end};
}

}  // namespace quell::cli
