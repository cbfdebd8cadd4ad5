// quell_bench: device time of every stage, beside what the memory could do.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <regex>
#include <string>

#include "bench/stage_bench.hpp"
#include "host/measure/copy_bandwidth.hpp"
#include "tests/support/stage_harness.hpp"

namespace {

using namespace quell;
using namespace quell::bench;

struct Arguments {
  std::string filter;
  std::string size = "1280x720";
  int repeat = 20;
  bool list = false;
};

Size parseSize(const std::string& text) {
  std::smatch match;
  if (!std::regex_match(text, match, std::regex("([1-9][0-9]{0,4})x([1-9][0-9]{0,4})")))
    throw std::runtime_error("--size: expected WIDTHxHEIGHT in pixels, got " + text);
  return {std::stoi(match[1]), std::stoi(match[2])};
}

std::vector<StageEntry> selectEntries(const Arguments& arguments) {
  const std::regex filter(arguments.filter);
  std::vector<StageEntry> selected;
  for (StageEntry& entry : stageEntries())
    if (std::regex_search(entry.name + "." + arguments.size, filter)) selected.push_back(std::move(entry));
  if (selected.empty()) throw std::runtime_error("--filter: no case matches " + arguments.filter);
  return selected;
}

CopyBandwidth printDevice() {
  const tests::TestDevice& shared = tests::TestDevice::shared();
  const CopyBandwidth copy = measureCopyBandwidth(shared.context(), shared.device(), shared.queue());
  fmt::print("device: {} ({}, driver {})\n", shared.device.getInfo<CL_DEVICE_NAME>(),
             shared.device.getInfo<CL_DEVICE_VERSION>(), shared.device.getInfo<CL_DRIVER_VERSION>());
  fmt::print("copy bandwidth: {:.2f} GB/s; one copy (1280x720, {:.1f} MB): {:.3f} ms\n\n",
             copy.gigabytesPerSecond, kCopyBytes * 1e-6, copy.copyMs);
  return copy;
}

void printTimes(const std::string& name, const StageTimes& times, const CopyBandwidth& copy) {
  const double gigabytesPerSecond = double(times.bytesMoved) / times.medianMs * 1e-6;
  fmt::print("{:<44} {:>9.3f} {:>9.3f} {:>9.3f} {:>8.1f} {:>8.2f} {:>7.1f} {:>7.2f}\n", name, times.medianMs,
             times.minMs, times.maxMs, double(times.bytesMoved) * 1e-6, gigabytesPerSecond,
             100.0 * gigabytesPerSecond / copy.gigabytesPerSecond, times.medianMs / copy.copyMs);
  std::fflush(stdout);
}

void runBenchmarks(const Arguments& arguments) {
  const Size size = parseSize(arguments.size);
  const std::vector<StageEntry> entries = selectEntries(arguments);
  if (arguments.list) {
    for (const StageEntry& entry : entries) fmt::print("{}.{}\n", entry.name, arguments.size);
    return;
  }
  const CopyBandwidth copy = printDevice();
  fmt::print("{:<44} {:>9} {:>9} {:>9} {:>8} {:>8} {:>7} {:>7}\n", "stage.variant.size", "median ms",
             "min ms", "max ms", "MB", "GB/s", "% copy", "copies");
  for (const StageEntry& entry : entries)
    printTimes(entry.name + "." + arguments.size, timeStage(entry, size, arguments.repeat), copy);
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{
      "Times every stage on the device that QUELL_TEST_DEVICE names (index or part of a name; by default the "
      "one that "
      "Quell prefers), after comparing its result with a double-precision oracle."};
  app.add_option("--filter", arguments.filter, "Regular expression that a case's name must contain");
  app.add_option("--size", arguments.size, "Image size in pixels, WIDTHxHEIGHT")->capture_default_str();
  app.add_option("--repeat", arguments.repeat, "Timed runs per case")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  app.add_flag("--list", arguments.list, "Print the names of the cases and exit");
  CLI11_PARSE(app, argc, argv);
  try {
    runBenchmarks(arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "quell_bench: {}\n", error.what());
    return 1;
  }
  return 0;
}
