// quell replay: runs captured frames once more and says whether the outputs are the same.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <quell/devices.hpp>
#include <quell/replay.hpp>
#include <string>
#include <vector>

#include "host/cli/common/commands.hpp"
#include "host/core/cl_error.hpp"
#include "host/core/opencl.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "replay";

struct ReplayOptions {
  std::string directory;
  std::string device;
  bool noCache = false;
};

void runReplay(const ReplayOptions& options) {
  const std::vector<Replay> replays = withClErrors(kCommand, [&] {
    const cl::Device device(chooseDevice(options.device).device, true);
    const cl::Context context(device);
    const cl::CommandQueue queue(context, device);
    return replay(options.directory, context(), device(), queue(),
                  options.noCache ? std::optional<std::string>("") : std::nullopt);
  });
  for (const Replay& one : replays) fmt::print("{}", toText(one));
  if (!std::all_of(replays.begin(), replays.end(), [](const Replay& one) { return one.equal(); }))
    throw CLI::RuntimeError(1);
}

}  // namespace

void addReplayCommand(CLI::App& app) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand(kCommand,
                                         "Run frames that were captured (QUELL_CAPTURE=DIR, "
                                         "docs/embedding.md) once more. Exit code 0: the outputs "
                                         "are equal, bit for bit; 1: they differ, or the folder is damaged");
  command->add_option("directory", options->directory, "A captured folder, or a folder of such")
      ->required()
      ->type_name("DIR");
  command->add_option("--device", options->device, "Index or part of a name, see 'quell devices'");
  command->add_flag("--no-cache", options->noCache, "Keep no compiled kernels on disk");
  command->callback([options] { runReplay(*options); });
}

}  // namespace quell::cli
