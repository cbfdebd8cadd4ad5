// quell stress: how far the fits lie from the best ones on random blocks of known trouble.
#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <quell/error.hpp>
#include <string>
#include <vector>

#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/commands.hpp"
#include "host/stress/frame_suite.hpp"
#include "host/stress/stress_suite.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "stress";

struct StressOptions {
  std::uint64_t blocks = 1000;  // of each family
  std::uint32_t seed = 1;
  std::string family;  // part of a name
  DeviceArguments device;
};

constexpr char kRowFormat[] = "{:<29} {:<4} {:<11} {:>15} {:>15} {:>10} {:>13} {:>13}  {}\n";

void printHeader() {
  fmt::print(kRowFormat, "", "", "", "worst excess", "worst predicted", "non-", "worst coeffi-",
             "worst outside", "");
  fmt::print(kRowFormat, "family", "class", "solver", "residual", "error", "finite", "cient error",
             "the range", "bound");
}

void printRow(const stress::Family& family, stress::Solver solver, const stress::SolverFigures& figures) {
  const bool well = family.posedness == stress::Posedness::Well;
  const auto share = [](double value) { return fmt::format("{:.2e}", value); };
  fmt::print(kRowFormat, family.name, well ? "well" : "ill", stress::solverName(solver),
             share(figures.worst.excessResidual), share(figures.worst.prediction),
             fmt::format("{:.2f} %", 100.0 * figures.nonFiniteShare()), share(figures.worst.coefficient),
             share(figures.worst.outsideRange),
             stress::withinBounds(figures, family.posedness) ? "kept" : "BROKEN");
}

void printLegend() {
  fmt::print(
      "\nExcess residual: energy above the least-squares minimum, per energy of the signal about its mean; "
      "at "
      "most {} in well-posed families.\nPredicted error, and distance outside the range of the data: per "
      "range "
      "of the channel; the latter at most {} in ill-posed families.\nCoefficient error: per largest "
      "coefficient, where the features are well-conditioned.\n",
      stress::kMostExcessResidual, stress::kMostOutsideRange);
}

template <class Family>
std::vector<Family> pickFamilies(const std::vector<Family>& all, const std::string& part) {
  std::vector<Family> picked;
  for (const Family& family : all)
    if (family.name.find(part) != std::string::npos) picked.push_back(family);
  return picked;
}

/// How many families gram breaks a bound of.
int runBlockFamilies(const StressOptions& options, const std::vector<stress::Family>& picked) {
  stress::FitterOptions fitterOptions;
  fitterOptions.device = options.device.device;
  fitterOptions.options = makeOptions(options.device, TimerMode::Off);
  stress::BlockFitter fitter(fitterOptions);
  fmt::print("{}, {} blocks a family, seed {}\n\n", fitter.deviceName(), options.blocks, options.seed);
  printHeader();

  const auto start = std::chrono::steady_clock::now();
  std::uint64_t blocks = 0;
  int broken = 0;
  for (const stress::Family& family : picked) {
    const stress::FamilyFigures figures = stress::runFamily(family, fitter, options.blocks, options.seed);
    for (const stress::Solver solver : stress::kSolvers) printRow(family, solver, figures.of(solver));
    std::fflush(stdout);
    blocks += figures.gram.blocks;
    broken += stress::withinBounds(figures.gram, family.posedness) ? 0 : 1;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  printLegend();
  fmt::print("{} blocks in {:.1f} s, {:.2f} s per 1000; gram breaks its bounds in {} of {} families\n",
             blocks, wall.count(), 1000.0 * wall.count() / static_cast<double>(blocks), broken,
             picked.size());
  return broken;
}

constexpr char kFrameRowFormat[] = "{:<25} {:<7} {:<7} {:>10} {:>14} {:>11} {:>11}  {}\n";

void printFrameRow(const stress::FrameFamily& family, const std::string& method,
                   const stress::FrameFigures& figures) {
  const auto share = [](double value) { return fmt::format("{:.2e}", value); };
  fmt::print(kFrameRowFormat, family.name, family.trace == stress::Trace::Gone ? "gone" : "fading", method,
             figures.nonFinite, share(figures.outsideRange), share(figures.peak), share(figures.left),
             stress::withinBounds(figures, family) ? "kept" : "BROKEN");
  std::fflush(stdout);
}

/// How many times a method breaks a bound of a family.
int runFrameFamilies(const StressOptions& options, const std::vector<stress::FrameFamily>& picked) {
  fmt::print("\n");
  fmt::print(kFrameRowFormat, "", "", "", "non-finite", "worst outside", "worst", "left at", "");
  fmt::print(kFrameRowFormat, "family", "class", "method", "frames", "the range", "difference", "the end",
             "bound");
  stress::FrameSuite suite(options.device.device, makeOptions(options.device, TimerMode::Off));
  int broken = 0;
  for (const stress::FrameFamily& family : picked) {
    const stress::FrameRuns runs = stress::makeFrameRuns(family, options.seed);
    for (const std::string& method : stress::frameMethods()) {
      const stress::FrameFigures figures = suite.run(family, runs, method);
      printFrameRow(family, method, figures);
      broken += stress::withinBounds(figures, family) ? 0 : 1;
    }
  }
  fmt::print(
      "\n{} frames a run, the fault in {} of them. Distance from the range of the clean frame, away from the "
      "fault: per range, at most {}.\nDifference from the clean run: mean, per mean of the picture; at the "
      "end at most "
      "{} (gone), or at most {} of its largest value (fading).\n",
      stress::kFramesInAll, stress::kFramesWithFault, stress::kMostOutsideFrameRange,
      stress::kMostLeftOfFault, stress::kMostLeftOfPeak);
  return broken;
}

/// Throws the exit code 1 if gram or a method breaks a bound.
void runStress(const StressOptions& options) {
  const auto blocks = pickFamilies(stress::families(), options.family);
  const auto frames = pickFamilies(stress::frameFamilies(), options.family);
  if (blocks.empty() && frames.empty())
    refuse(kCommand, "--family", "part of the name of a family", options.family);
  int broken = 0;
  if (!blocks.empty()) broken += runBlockFamilies(options, blocks);
  if (!frames.empty()) broken += runFrameFamilies(options, frames);
  if (broken > 0) throw CLI::RuntimeError(1);
}

}  // namespace

void addStressCommand(CLI::App& app) {
  auto options = std::make_shared<StressOptions>();
  CLI::App* command = app.add_subcommand(kCommand,
                                         "Compare the fits with double precision on random blocks, and run "
                                         "all methods over frames with faults; fails if a "
                                         "bound is broken");
  command->add_option("--blocks", options->blocks, "Blocks of each family")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of the random blocks")->capture_default_str();
  command->add_option("--family", options->family, "Only families with this in their name");
  addDeviceArguments(*command, options->device);
  command->callback([options] { runStress(*options); });
}

}  // namespace quell::cli
