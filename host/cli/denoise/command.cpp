// quell denoise: a sequence in, denoised frames, times and errors out.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/analytic/sequence.hpp"
#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/commands.hpp"
#include "host/cli/common/denoise_report.hpp"
#include "host/cli/common/denoise_session.hpp"
#include "host/cli/common/fair_rounds.hpp"
#include "host/cli/common/output_files.hpp"
#include "host/cli/common/progress.hpp"
#include "host/cli/common/sequence_arguments.hpp"
#include "host/cli/common/watched_sequence.hpp"
#include "host/cli/denoise/further_outputs.hpp"
#include "host/io/atomic_file.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "denoise";
/// Stands for the names of all buffers in --dump.
constexpr char kList[] = "list";
/// Frames after which a history is about as good as it gets: the default of historyFrames, of what moves, and one.
constexpr int kUsualPreroll = 8;

struct DenoiseOptions {
  MethodArguments method;
  std::vector<std::string> input;
  std::string output;
  std::string frames;
  int preroll = 0;
  std::string size = "1280x720";
  std::string timers = "device";
  std::string motion = "auto";
  std::string json;
  std::vector<std::string> dump;
  io::SequenceOptions reading;
  DeviceArguments device;
  int analyticFrames = 16;
  double skyShare = 0.0;
  bool stillCamera = false;
  bool debugTiles = false;
  bool png = false;
  bool exr = false;
  bool floats = false;
  FurtherOutputs further;
  bool copyBandwidth = false;
};

std::unique_ptr<io::FrameSequence> openInput(const DenoiseOptions& options) {
  if (!options.input.empty()) {
    io::SequenceOptions reading = options.reading;
    reading.furtherFiles.assign(options.input.begin() + 1, options.input.end());
    return openWatched(options.input.front(), reading);
  }
  if (options.reading.signals != 1) refuse(kCommand, "--signals", "1 with the built-in sequence", "2");
  const Size size = parseSize(kCommand, options.size);
  io::AnalyticOptions analytic;
  analytic.width = size.width;
  analytic.height = size.height;
  analytic.frameCount = options.analyticFrames;
  analytic.skyShare = options.skyShare;
  analytic.movingCamera = !options.stillCamera;
  return io::makeAnalyticSequence(analytic);
}

TimerMode timerMode(const std::string& name) {
  if (name == "off") return TimerMode::Off;
  return name == "host" ? TimerMode::Host : TimerMode::Device;
}

std::unique_ptr<OutputFiles> openOutput(const DenoiseOptions& options) {
  if (options.output.empty() && (options.debugTiles || !options.dump.empty()))
    refuse(kCommand, options.debugTiles ? "--debug tiles" : "--dump", "--output as well", "none");
  if (options.output.empty() && options.further.any())
    refuse(kCommand, "--pfm, --accumulated or --multilayer", "--output as well", "none");
  if (options.input.empty() && options.further.multilayer)
    refuse(kCommand, "--multilayer", "--input as well", "the built-in sequence");
  if (options.output.empty()) return nullptr;
  return std::make_unique<OutputFiles>(
      options.output, OutputFormats{options.png || !options.exr, options.exr,
                                    options.floats ? io::ExrType::Float : io::ExrType::Half});
}

/// Null where there is nothing further to write.
std::unique_ptr<FurtherOutputWriter> openFurther(const io::FrameSequence& sequence,
                                                 const DenoiseOptions& options, const Settings& settings,
                                                 int firstFrame, const OutputFiles* files) {
  if (files == nullptr || !options.further.any()) return nullptr;
  std::unique_ptr<DenoiseSession> accumulation;
  if (options.further.accumulated)
    accumulation = std::make_unique<DenoiseSession>(
        options.device.device, accumulationSettings(settings, sequence),
        makeOptions(options.device, TimerMode::Off), sequence.read(firstFrame), motionUse(options.motion));
  return std::make_unique<FurtherOutputWriter>(options.further, *files, sequence, options.reading.signals,
                                               std::move(accumulation));
}

/// Whether frames depend on those before: then the method reads motion where there is any.
bool hasHistory(const Settings& settings) {
  const std::vector<InputNeed> needs = inputNeeds(settings);
  return std::any_of(needs.begin(), needs.end(), [](const InputNeed& need) {
    return need.image == "motion" && need.use != InputUse::Unused;
  });
}

/// Frames that the history takes in before the first one that is written; says so where more of them would help.
std::vector<int> choosePreroll(const io::FrameSequence& sequence, int first, const DenoiseOptions& options,
                               const Settings& settings) {
  const std::vector<int> frames = prerollFrames(sequence.frames(), first, options.preroll);
  if (options.preroll == 0 && first > sequence.frames().front() && hasHistory(settings))
    fmt::print(
        stderr,
        "frame {} begins without a history, as after a cut: --preroll {} takes in the frames before it, "
        "unwritten\n",
        first, kUsualPreroll);
  sequence.requireReadable(frames);
  return frames;
}

void takeIn(const io::FrameSequence& sequence, const std::vector<int>& frames, DenoiseSession& session,
            FurtherOutputWriter* further) {
  for (const int number : frames) {
    const io::FrameData frame = sequence.read(number);
    session.denoise(frame);
    if (further != nullptr) further->preroll(frame);
  }
}

// Denoises the frames, writes what there is to write of each, and fills the report's frames, errors and hash.
void denoiseFrames(const io::FrameSequence& sequence, const std::vector<int>& frames,
                   const DenoiseOptions& options, DenoiseSession& session, const OutputFiles* files,
                   FurtherOutputWriter* further, DenoiseReport& report) {
  OutputHash hash;
  metrics::MotionCompensatedErrorMeter flicker;
  io::References references(sequence);
  Progress progress(kCommand, frames.size());
  for (const int number : frames) {
    const io::FrameData frame = sequence.read(number);
    const DenoisedFrame denoised = session.denoise(frame);
    hash.add(denoised.linear);
    hash.add(denoised.display);
    flicker.add(trackFrame(frame, denoised));
    if (files != nullptr) files->write(frame, denoised);
    if (further != nullptr) further->write(frame, denoised);
    for (const std::string& name : options.dump)
      files->writeBuffer(number, session.denoiser().readBuffer(name));
    if (options.debugTiles) files->writeTiles(number, denoised, session.denoiser().backgroundMap());
    if (const auto& reference = references.of(number)) {
      if (frame.comparable()) report.errors.push_back(compareFrame(frame, denoised, *reference));
      if (files != nullptr) files->writeComparison(frame, denoised, *reference);
    }
    ++report.frames;
    progress.step(fmt::format("frame {}", number));
  }
  report.outputHash = hash.text();
  report.temporalError = flicker.mean();
}

void runDenoise(const DenoiseOptions& options) {
  const std::unique_ptr<io::FrameSequence> sequence = openInput(options);
  const std::vector<int> frames = chooseFrames(kCommand, sequence->frames(), options.frames);
  sequence->requireReadable(frames);
  for (const std::string& line : sequence->describeChannels()) fmt::print("{}\n", line);
  const Settings settings =
      applyMethodArguments(kCommand, options.method, defaultSettings(options.method.method, *sequence));
  const std::vector<int> preroll = choosePreroll(*sequence, frames.front(), options, settings);
  const int first = preroll.empty() ? frames.front() : preroll.front();
  const bool list = options.dump == std::vector<std::string>{kList};
  const std::unique_ptr<OutputFiles> files = list ? nullptr : openOutput(options);
  Options deviceOptions = makeOptions(options.device, timerMode(options.timers));
  if (!list) deviceOptions.keptBuffers = options.dump;
  DenoiseSession session(options.device.device, settings, deviceOptions, sequence->read(first),
                         motionUse(options.motion));
  if (list) {
    fmt::print("{}\n", fmt::join(session.denoiser().bufferNames(), "\n"));
    return;
  }
  DenoiseReport report;
  report.device = session.device();
  report.settings = settings;
  report.size = {sequence->width(), sequence->height()};
  const auto further = openFurther(*sequence, options, settings, first, files.get());
  takeIn(*sequence, preroll, session, further.get());
  denoiseFrames(*sequence, frames, options, session, files.get(), further.get(), report);
  report.memory = session.denoiser().memoryUse();
  if (options.timers != "off") report.timings = session.timings();
  if (options.copyBandwidth) {
    const CopyBandwidth copy = measureCopy(session);
    report.copyMs = copy.copyMs;
    report.copyGbs = copy.gigabytesPerSecond;
  }
  writeJson(options.json, toJson(report));
  print(report);
  if (files) fmt::print("\npictures and frames are in {}\n", options.output);
}

void addFurtherOptions(CLI::App* command, FurtherOutputs& further) {
  command->add_flag("--pfm", further.pfm, "Write denoised_NNNN.pfm as well");
  command->add_flag(
      "--accumulated", further.accumulated,
      "Write accumulated_NNNN.exr as well: linear, the history of the method quell before its filter, "
      "for denoisers that look at one frame alone");
  command->add_flag("--multilayer", further.multilayer,
                    "Write multilayer_NNNN.exr as well: all that was read, with the pass Denoised beside it");
}

void addInputOptions(CLI::App* command, const std::shared_ptr<DenoiseOptions>& options) {
  command->add_option(
      "--input", options->input,
      "OpenEXR files as a renderer writes them: one or several, a directory, shot_####.exr, "
      "shot_%04d.exr or a glob (docs/frames-from-my-renderer.md), or a sequence in the layout of "
      "data/README.md; without it a built-in sequence is made up. Files of renderers need colour, "
      "normal and position, or depth and a camera");
  command->add_option("--frames", options->frames, "Frames A-B (A:B where one is negative); default: all");
  command
      ->add_option("--preroll", options->preroll,
                   "Frames before those of --frames that the history takes in; they are not written")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--size", options->size, "Size of the built-in sequence")->capture_default_str();
  command->add_option("--frame-count", options->analyticFrames, "Length of the built-in sequence")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--sky-share", options->skyShare, "Share of the built-in sequence's rows that show sky")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_flag("--still-camera", options->stillCamera,
                    "The camera of the built-in sequence stands still");
}

}  // namespace

void addDenoiseCommand(CLI::App& app) {
  auto options = std::make_shared<DenoiseOptions>();
  CLI::App* command = app.add_subcommand("denoise", "Denoise a frame sequence and report time and error");
  addMethodArguments(*command, options->method);
  addInputOptions(command, options);
  command->add_option("--output", options->output,
                      "Directory for denoised_NNNN.exr and display_NNNN.png or .exr");
  addSignalsOption(*command, options->reading.signals);
  addSequenceOptions(*command, options->reading);
  addMotionOption(*command, options->motion);
  command->add_option("--timers", options->timers, "Where stage times come from")
      ->check(CLI::IsMember({"device", "host", "off"}))
      ->capture_default_str();
  addDeviceArguments(*command, options->device);
  command->add_option("--json", options->json, "File for the report as JSON");
  command
      ->add_option_function<std::string>(
          "--debug", [options](const std::string&) { options->debugTiles = true; },
          "tiles: write tiles_NNNN.png, darkened where background is left out")
      ->check(CLI::IsMember({"tiles"}));
  command
      ->add_option(
          "--dump", options->dump,
          "Intermediate buffers to write as NAME_NNNN.exr, separated by commas; list: print their names")
      ->delimiter(',');
  command->add_flag("--png", options->png, "Write display images as PNG (the default)");
  command->add_flag("--exr", options->exr, "Write display images as OpenEXR");
  command->add_flag("--float", options->floats,
                    "Write OpenEXR files as 32-bit floats; default: half, 6e-8 to 65504");
  addFurtherOptions(command, options->further);
  command->add_flag("--copy-bandwidth", options->copyBandwidth,
                    "Also measure the device's copy bandwidth and report times in copies");
  command->footer(settingsHelp("--set"));
  command->callback([options] { runDenoise(*options); });
}

}  // namespace quell::cli
