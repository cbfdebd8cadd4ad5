// quell demo: a path tracer with the denoiser in it, and a page to look at what comes out.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/commands.hpp"
#include "host/cli/common/denoise_report.hpp"
#include "host/cli/common/output_files.hpp"
#include "host/cli/common/progress.hpp"
#include "host/cli/common/sequence_arguments.hpp"
#include "host/cli/demo/page.hpp"
#include "host/cli/demo/pipeline.hpp"
#include "host/core/program_cache.hpp"
#include "host/io/atomic_file.hpp"
#include "host/io/png_image.hpp"

namespace quell::cli {
namespace {

constexpr char kCommand[] = "demo";
constexpr int kMostFrames = 10000;  // four digits in file names
constexpr int kMostSamples = 1 << 20;
constexpr char kPageName[] = "index.html";

struct DemoArguments {
  MethodArguments method;
  DeviceArguments device;
  std::string scene = "columns";
  std::string output;
  std::string size = "480x270";
  std::string referenceFrames = "last";
  std::string motion = "auto";
  std::string json;
  int frames = 30;
  int samples = 1;
  int referenceSamples = 128;
  int signals = 1;
  std::uint32_t seed = 1;
};

DemoSetup makeSetup(const DemoArguments& arguments) {
  DemoSetup setup;
  setup.scene = arguments.scene;
  setup.size = parseSize(kCommand, arguments.size);
  setup.samples = arguments.samples;
  setup.seed = arguments.seed;
  setup.signals = arguments.signals;
  setup.motion = motionUse(arguments.motion) == MotionUse::WherePresent;
  setup.device = arguments.device.device;
  setup.settings = applyMethodArguments(kCommand, arguments.method, Settings(arguments.method.method));
  setup.options = makeOptions(arguments.device, TimerMode::Device);
  setup.tracerCache = setup.options.cacheDirectory.value_or(defaultCacheDirectory());
  return setup;
}

bool wantsReference(const DemoArguments& arguments, int frame) {
  if (arguments.referenceSamples == 0) return false;
  return arguments.referenceFrames == "all" || frame == arguments.frames - 1;
}

std::string sampleCount(int samples) { return fmt::format("{} sample{}", samples, samples == 1 ? "" : "s"); }

class Demo {
 public:
  explicit Demo(const DemoArguments& arguments)
      : m_arguments(arguments), m_setup(makeSetup(arguments)), m_pipeline(m_setup) {
    m_report.device = m_pipeline.device();
    m_report.settings = m_setup.settings;
    m_report.size = m_setup.size;
  }

  void run() {
    Progress progress(kCommand, static_cast<std::size_t>(m_arguments.frames));
    for (int frame = 0; frame < m_arguments.frames; ++frame) {
      runFrame(frame);
      progress.step(fmt::format("frame {}", frame));
    }
    m_report.frames = m_sheets.size();
    m_report.memory = m_pipeline.memoryUse();
    m_report.outputHash = m_hash.text();
    m_report.timings = m_pipeline.denoisingTimes();
  }

  void finish() {
    const Timings tracing = m_pipeline.tracingTimes();
    const std::string text = tracingText(tracing) + "\n" + toText(withLastError());
    fmt::print("{}", text);
    writeJson(m_arguments.json, json(tracing));
    const std::string page = inOutput(kPageName);
    io::writeTextFile(page, makeDemoPage({title(), subtitle(), text, m_setup.size, paneNames(), m_sheets}));
    fmt::print("\nopen {} in a browser; frames are beside it\n", page);
  }

 private:
  void runFrame(int frame) {
    m_pipeline.enqueue(frame);
    const DemoPictures pictures = m_pipeline.read();
    m_hash.add(pictures.denoised.linear);
    m_hash.add(pictures.denoised.display);
    std::optional<io::Reference> reference;
    if (wantsReference(m_arguments, frame)) {
      reference = m_pipeline.reference(frame, m_arguments.referenceSamples);
      io::FrameData noisy;
      noisy.number = frame;
      noisy.radiance = pictures.noisy;
      m_report.errors.push_back(compareFrame(noisy, pictures.denoised, *reference));
    }
    writeSheet(frame, comparisonSheet(pictures.noisy, pictures.denoised, reference ? &*reference : nullptr));
  }

  void writeSheet(int frame, const io::Image& sheet) {
    const std::string png = io::encodePng(sheet);
    const std::string path = inOutput(fmt::format("comparison_{:04}.png", frame));
    io::writeBinaryFile(path, png.data(), png.size());
    m_sheets.push_back({frame, sheet.width / m_setup.size.width, path, png.size()});
  }

  /// Errors of many frames would be a wall of figures; the JSON report has them all.
  DenoiseReport withLastError() const {
    DenoiseReport report = m_report;
    if (report.errors.size() > 1) report.errors.erase(report.errors.begin(), report.errors.end() - 1);
    return report;
  }

  std::string inOutput(const std::string& name) const {
    return (std::filesystem::path(m_arguments.output) / name).string();
  }

  std::string tracingText(const Timings& tracing) const {
    std::string text = fmt::format(
        "path tracer, scene {}, {} per pixel, same context and queue as the denoiser\n\n"
        "  {:<24}{:>9}{:>9}{:>9}\n",
        m_setup.scene, sampleCount(m_setup.samples),
        fmt::format("kernel ({} time, ms)", toString(tracing.source)), "median", "min", "max");
    const auto row = [&](const std::string& name, const TimeStatistics& time) {
      text += fmt::format("  {:<24}{:>9.2f}{:>9.2f}{:>9.2f}\n", name, time.medianMs, time.minMs, time.maxMs);
    };
    for (const StageTimings& stage : tracing.stages) row(stage.stage, stage.time);
    row("frame, gaps included", tracing.frame);
    return text;
  }

  nlohmann::json json(const Timings& tracing) const {
    nlohmann::json result = toJson(m_report);
    result["scene"] = m_setup.scene;
    result["samples"] = m_setup.samples;
    result["tracing"] = toJson(tracing);
    return result;
  }

  std::vector<std::string> paneNames() const {
    return {fmt::format("noisy, {} per pixel", sampleCount(m_setup.samples)), "denoised",
            fmt::format("reference, {} per pixel", sampleCount(2 * m_arguments.referenceSamples))};
  }

  std::string title() const {
    return fmt::format("Quell demo: method {}, scene {}", m_setup.settings.method(), m_setup.scene);
  }
  std::string subtitle() const {
    return fmt::format("{}x{}, {} per pixel, traced and denoised on {}", m_setup.size.width,
                       m_setup.size.height, sampleCount(m_setup.samples), m_pipeline.device().name);
  }

  const DemoArguments& m_arguments;
  DemoSetup m_setup;
  DemoPipeline m_pipeline;
  DenoiseReport m_report;
  OutputHash m_hash;
  std::vector<DemoSheet> m_sheets;
};

void runDemo(const DemoArguments& arguments) {
  createDirectory(kCommand, arguments.output);
  Demo demo(arguments);
  demo.run();
  demo.finish();
}

}  // namespace

void addDemoCommand(CLI::App& app) {
  auto arguments = std::make_shared<DemoArguments>();
  CLI::App* command = app.add_subcommand(
      kCommand, "Trace and denoise a built-in scene on one queue; leaves a page to look at");
  command
      ->add_option("--output", arguments->output,
                   fmt::format("Directory for {} and comparison_NNNN.png", kPageName))
      ->required();
  command->add_option("--scene", arguments->scene, "Scene, see 'quell render --help'")
      ->check(CLI::IsMember(render::sceneNames()))
      ->capture_default_str();
  command->add_option("--frames", arguments->frames, "Number of frames")
      ->check(CLI::Range(1, kMostFrames))
      ->capture_default_str();
  command->add_option("--size", arguments->size, "Pixels")->capture_default_str();
  command->add_option("--spp", arguments->samples, "Samples per pixel")
      ->check(CLI::Range(1, kMostSamples))
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "Seed of the random numbers")->capture_default_str();
  command
      ->add_option("--reference", arguments->referenceSamples,
                   "Samples per pixel of each half of the references; 0: none")
      ->check(CLI::Range(0, kMostSamples))
      ->capture_default_str();
  command->add_option("--reference-frames", arguments->referenceFrames, "Frames with a reference")
      ->check(CLI::IsMember({"last", "all"}))
      ->capture_default_str();
  addSignalsOption(*command, arguments->signals);
  addMotionOption(*command, arguments->motion);
  addMethodArguments(*command, arguments->method);
  addDeviceArguments(*command, arguments->device);
  command->add_option("--json", arguments->json, "File for the report as JSON");
  command->footer("Settings for --set are listed by 'quell denoise --help'.");
  command->callback([arguments] { runDemo(*arguments); });
}

}  // namespace quell::cli
