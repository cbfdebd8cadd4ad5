// quell check: what is odd about the frames of a sequence, and what would cure it.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <quell/error.hpp>
#include <string>
#include <utility>

#include "host/cli/check/page.hpp"
#include "host/cli/check/pictures.hpp"
#include "host/cli/check/report.hpp"
#include "host/cli/common/commands.hpp"
#include "host/cli/common/output_files.hpp"
#include "host/cli/common/sequence_arguments.hpp"
#include "host/io/atomic_file.hpp"
#include "host/io/png_image.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "check";

struct CheckOptions {
  std::string input;
  std::string frames;
  std::string json;
  std::string pictures;
  std::string html;
  io::SequenceOptions reading;
  int frameCount = 4;
};

std::vector<int> framesToCheck(const CheckOptions& options, std::vector<int> frames) {
  if (options.frames.empty()) frames.resize(std::min(frames.size(), std::size_t(options.frameCount)));
  return chooseFrames(kCommand, std::move(frames), options.frames);
}

using Pngs = std::map<std::string, std::string>;  // by kind

/// Writes pictures where there is a directory, and keeps the first of each kind in `pngs` where there is a page.
FindingSink pictureSink(const CheckOptions& options, Pngs& pngs) {
  if (options.pictures.empty() && options.html.empty()) return {};
  if (!options.pictures.empty()) createDirectory(kCommand, options.pictures);
  return [&options, &pngs](const io::FrameData& frame, const check::MappedFinding& found) {
    const io::Image picture = pictureOf(frame, found);
    const std::string& kind = found.finding.kind;
    if (!options.html.empty() && pngs.count(kind) == 0) pngs[kind] = io::encodePng(picture);
    if (options.pictures.empty()) return;
    const std::string name = fmt::format("{}_{:04d}.png", kind, frame.number);
    io::writePng((std::filesystem::path(options.pictures) / name).string(), picture);
  };
}

void runCheck(const CheckOptions& options) {
  const std::unique_ptr<io::FrameSequence> sequence = io::openSequence(options.input, options.reading);
  for (const std::string& line : sequence->describeChannels()) fmt::print("{}\n", line);
  Pngs pngs;
  const SequenceCheck check =
      checkSequence(*sequence, framesToCheck(options, sequence->frames()), pictureSink(options, pngs));
  fmt::print("{}", checkText(sequence->name(), check));
  std::fflush(stdout);  // the JSON may go to the same place
  writeJson(options.json, checkJson(sequence->name(), check));
  if (!options.html.empty()) io::writeTextFile(options.html, checkPage(sequence->name(), check, pngs));
  if (const int code = exitCodeOf(check.worst()); code != 0) throw CLI::RuntimeError(code);
}

/// Whoever asks whether frames are fine learns that they are not.
void runCheckOrFail(const CheckOptions& options) {
  try {
    runCheck(options);
  } catch (const Error& error) {
    fmt::print(stderr, "quell: {}\n", error.what());
    throw CLI::RuntimeError(exitCodeOf(Severity::Wrong));
  }
}

}  // namespace

void addCheckCommand(CLI::App& app) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand(kCommand,
                                         "Say what is odd about the frames of a sequence, and what would "
                                         "cure it. Exit code 0: fine, 1: doubtful, 2: wrong "
                                         "or not readable");
  command->add_option("input", options->input, "Directory or file as for quell denoise --input")
      ->required()
      ->type_name("DIR|FILE");
  command
      ->add_option("--frames", options->frames,
                   "Frames A-B (A:B where one is negative); default: the first ones")
      ->type_name("A-B");
  command->add_option("--frame-count", options->frameCount, "How many of the first frames")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addSequenceOptions(*command, options->reading);
  command->add_option("--json", options->json, "Write figures and findings to this file as JSON")
      ->type_name("FILE");
  command
      ->add_option("--pictures", options->pictures,
                   "Write KIND_NNNN.png for each finding into this directory: the image, and where it is odd")
      ->type_name("DIR");
  command->add_option("--html", options->html, "Write it all as one page with pictures to this file")
      ->type_name("FILE");
  command->callback([options] { runCheckOrFail(*options); });
}

}  // namespace quell::cli
