// quell f-beta: the F_beta table as a picture, and how long it takes to have it.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <quell/quell.hpp>
#include <string>

#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/commands.hpp"
#include "host/core/cl_error.hpp"
#include "host/io/exr_image.hpp"
#include "host/stages/f_beta_table.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "f-beta";

struct FBetaOptions {
  std::string output;
  bool correlated = false;
  DeviceArguments device;
};

void writeTable(const FBetaOptions& options) {
  const DeviceInfo info = chooseDevice(options.device.device);
  const cl::Device device(info.device, true);
  const cl::Context context(device);
  const cl::CommandQueue queue(context, device);
  const Options denoiserOptions = makeOptions(options.device, TimerMode::Off);
  const ProgramCache programs(denoiserOptions.cacheDirectory.value_or(defaultCacheDirectory()));

  const auto start = std::chrono::steady_clock::now();
  const FBetaTable table(context, device, queue, queryDeviceTraits(device, denoiserOptions.mapping), programs,
                         options.correlated ? Shadowing::HeightCorrelated : Shadowing::Separable);
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;

  io::Image image(FBetaTable::edge(), FBetaTable::edge(), 2);
  image.pixels = table.texels(queue);
  io::writeExr(options.output, image, io::ExrType::Float);
  fmt::print("{}: {} in {:.1f} ms, {} masking-shadowing\n", info.name,
             table.fromDisk() ? "read from the cache" : "compiled and computed", wall.count(),
             options.correlated ? "height-correlated" : "separable");
  fmt::print(
      "{}: F_beta = F0 * R + G; column x is cos(theta_o) = (x / {})^2, row y is roughness = y / {}, "
      "alpha = roughness^2\n",
      options.output, FBetaTable::edge() - 1, FBetaTable::edge() - 1);
}

}  // namespace

void addFBetaCommand(CLI::App& app) {
  auto options = std::make_shared<FBetaOptions>();
  CLI::App* command = app.add_subcommand(
      kCommand, "Write the table of the pre-integrated BRDF that glossy signals are divided by");
  command->add_option("--output", options->output, "OpenEXR file to write")->required();
  command->add_flag("--correlated", options->correlated,
                    "Height-correlated masking-shadowing (default: separable)");
  addDeviceArguments(*command, options->device);
  command->callback([options] { withClErrors(kCommand, [&] { writeTable(*options); }); });
}

}  // namespace quell::cli
