// quell render: noisy sequences with all buffers and references, from built-in scenes.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/commands.hpp"
#include "host/cli/common/progress.hpp"
#include "host/core/program_cache.hpp"
#include "host/render/render_sequence.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "render";

struct RenderArguments {
  render::RenderOptions render;
  std::string size = "640x360";
  std::string device;
  std::string cacheDirectory;
  bool noCache = false;
};

std::string sceneHelp() {
  std::string text = "Scenes:\n";
  for (const render::SceneEntry& scene : render::scenes())
    text += fmt::format("  {:<16} {}\n", scene.name, scene.summary);
  return text;
}

void runRender(RenderArguments& arguments) {
  render::RenderOptions& options = arguments.render;
  options.settings.size = parseSize(kCommand, arguments.size);
  options.device = arguments.device;
  if (!arguments.noCache)
    options.cacheDirectory =
        arguments.cacheDirectory.empty() ? defaultCacheDirectory() : arguments.cacheDirectory;
  if (!options.referenceFrames.empty() && options.settings.referenceSamples == 0)
    refuse(kCommand, "--reference-frames", "--reference besides", "none");
  const auto start = std::chrono::steady_clock::now();
  ShareProgress progress(kCommand);
  const render::RenderReport report = render::renderSequence(
      options, [&](double share, const std::string& what) { progress.show(share, what); });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  fmt::print("{}: {} frames rendered, {} kept; {} reference halves rendered, {} kept; {:.1f} s on {}\n",
             options.output, report.framesRendered, report.framesKept, report.halvesRendered,
             report.halvesKept, wall.count(), report.device);
}

}  // namespace

void addRenderCommand(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  render::RenderOptions& options = arguments->render;
  CLI::App* command =
      app.add_subcommand(kCommand, "Render a noisy test sequence with all buffers from a built-in scene");
  command->add_option("--scene", options.settings.scene, "One of the scenes below")->required();
  command->add_option("--output", options.output, "Directory; what is there already and whole is kept")
      ->required();
  command->add_option("--frames", options.frameCount, "Number of frames")->capture_default_str();
  command->add_option("--spp", options.settings.samples, "Samples per pixel")->capture_default_str();
  command->add_option("--size", arguments->size, "Pixels")->capture_default_str();
  command->add_option("--seed", options.settings.seed, "Seed of the random numbers")->capture_default_str();
  command->add_flag(
      "--jitter", options.settings.jitter,
      "Primary rays leave the pixel centres, by another offset in every frame (jitter_px in camera.json)");
  command
      ->add_option("--reference", options.settings.referenceSamples,
                   "Samples per pixel of each half of the references; 0: none. With --jitter there are two "
                   "of a frame: "
                   "through pixel centres and antialiased")
      ->capture_default_str();
  command
      ->add_option(
          "--reference-frames", options.referenceFrames,
          "Frames with a reference, separated by commas; default: the last one, and in light-switch the one "
          "before the switch")
      ->delimiter(',');
  command->add_option("--device", arguments->device, "Index or part of a name, see 'quell devices'");
  command->add_option("--cache-directory", arguments->cacheDirectory, "Where compiled kernels are kept");
  command->add_flag("--no-cache", arguments->noCache, "Keep no compiled kernels on disk");
  command->footer(sceneHelp());
  command->callback([arguments] { runRender(*arguments); });
}

}  // namespace quell::cli
