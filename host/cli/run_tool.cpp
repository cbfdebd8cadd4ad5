#include "host/cli/run_tool.hpp"

#include <fmt/format.h>
#include <quell/quell.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <quell/error.hpp>

#include "host/cli/common/commands.hpp"

namespace quell::cli {

int runTool(int argc, const char* const* argv) {
  CLI::App app{"Quell removes the noise from path-traced frame sequences on any OpenCL device.", "quell"};
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string("quell ") + quellVersion());
  addDenoiseCommand(app);
  addCheckCommand(app);
  addCompareCommand(app);
  addDevicesCommand(app);
  addReplayCommand(app);
  addRenderCommand(app);
  addDemoCommand(app);
#ifdef QUELL_ALL_COMMANDS
  addBenchCommand(app);
  addFBetaCommand(app);
  addKernelsCommand(app);
  addSelectFeaturesCommand(app);
  addStressCommand(app);
  addTuneDeviceCommand(app);
  addTuneCommand(app);
#endif
  addManualCommands(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::RuntimeError& error) {
    return app.exit(error);  // a command's own code
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;  // not CLI11's own numbers: 1 is an error, whatever its kind
  } catch (const std::exception& error) {
    std::fflush(stdout);  // what was said before comes before
    fmt::print(stderr, "quell: {}\n", error.what());
    return 1;
  }
}

}  // namespace quell::cli
