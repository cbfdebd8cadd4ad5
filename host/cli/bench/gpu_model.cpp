#include "host/cli/bench/gpu_model.hpp"

#include <string>

#include "host/cli/bench/roofline.hpp"

namespace quell::cli {
namespace {

using nlohmann::json;

constexpr double kPixels = 1280.0 * 720.0;

// Peak rates as the makers publish them.
struct Gpu {
  const char* name;
  double gigabytesPerSecond;
  double gigaflops;  // single precision
};
constexpr Gpu kGpus[] = {{"Radeon Vega Frontier Edition", 483.8, 13107.0},
                         {"Titan X (Pascal)", 480.4, 10974.0},
                         {"GeForce RTX 3070", 448.0, 20314.0},
                         {"Radeon RX 7900 XTX", 960.0, 61390.0}};

// Times of the papers' own implementations at 1280x720.
struct PublishedTime {
  const char* method;
  const char* gpu;
  const char* text;
};
constexpr PublishedTime kPublished[] = {
    {"bmfr", "Radeon Vega Frontier Edition", "2.4 ms, Koskela et al. 2019"},
    {"bmfr", "Titan X (Pascal)", "2.2 to 2.3 ms, Flatval 2020"},
    {"svgf", "Titan X (Pascal)", "4.4 ms, Koskela et al. 2019; 5.2 to 5.9 ms, Flatval 2020"}};

std::string published(const std::string& method, const std::string& gpu) {
  for (const PublishedTime& time : kPublished)
    if (method == time.method && gpu == time.gpu) return time.text;
  return "";
}

double predictMs(const BenchRun& run, const Gpu& gpu, const OperationCounts& operations) {
  const double scale = kPixels / (double(run.report.size.width) * double(run.report.size.height));
  double ms = 0.0;
  for (const StageTimings& stage : run.report.timings->stages)
    ms += rooflineMs(double(stage.bytesMoved) * scale,
                     operations.perPixel(run.plan, stage.label) * kPixels * workShare(stage),
                     gpu.gigabytesPerSecond, gpu.gigaflops);
  return ms;
}

}  // namespace

json predictGpus(const BenchResult& result) {
  json gpus = json::array(), rows = json::array();
  for (const Gpu& gpu : kGpus)
    gpus.push_back({{"name", gpu.name}, {"gbs", gpu.gigabytesPerSecond}, {"gflops", gpu.gigaflops}});
  for (const BenchRun& run : result.runs) {
    const BenchRun& first = result.runs.front();
    if (!run.plan.sweep.empty() || run.input != first.input || run.report.size != first.report.size) continue;
    json ms = json::array(), texts = json::array();
    for (const Gpu& gpu : kGpus) {
      ms.push_back(predictMs(run, gpu, result.operations));
      texts.push_back(published(run.plan.method, gpu.name));
    }
    rows.push_back({{"run", run.plan.name()}, {"ms", ms}, {"published", texts}});
  }
  return {{"note",
           "A prediction, not a measurement: every stage is given the time that its bytes take at the GPU's "
           "published "
           "bandwidth, or its counted operations at the published rate of multiply-adds, whichever is "
           "longer. Nothing "
           "is added for latency, launches or caches that are too small: real times are longer. Published "
           "times are "
           "those of the papers' own implementations."},
          {"gpus", gpus},
          {"rows", rows}};
}

}  // namespace quell::cli
