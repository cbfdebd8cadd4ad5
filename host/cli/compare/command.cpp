// quell compare: error figures of images against a converged reference.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/commands.hpp"
#include "host/cli/common/figures.hpp"
#include "host/cli/common/output_files.hpp"
#include "host/cli/common/progress.hpp"
#include "host/cli/compare/pictures.hpp"
#include "host/io/frame_sequence.hpp"
#include "host/io/png_image.hpp"
#include "host/metrics/color_map.hpp"
#include "host/metrics/display_encoding.hpp"
#include "host/metrics/report.hpp"
#include "host/metrics/ssim.hpp"
#include "host/metrics/temporal.hpp"

namespace quell::cli {
namespace {

namespace fs = std::filesystem;

struct CompareOptions {
  std::string reference;  // A.exr or A.exr,B.exr
  std::vector<std::string> images;
  std::string size;  // of raw files; empty: that of the reference
  std::string jsonFile;
  std::string heatmapDirectory;
};

struct ComparedImage {
  std::string path;
  metrics::ErrorFigures figures;
  std::size_t notFinite = 0;  ///< pixels
};

/// What a picture holds that no figure can be made of.
struct PixelFaults {
  std::size_t nan = 0;       ///< pixels with a channel that is not a number
  std::size_t infinite = 0;  ///< further ones with an infinite channel
};

PixelFaults faultsOf(const io::Image& image) {
  PixelFaults faults;
  for (auto pixel = image.pixels.begin(); pixel != image.pixels.end(); pixel += image.channels) {
    const auto any = [&](auto is) { return std::any_of(pixel, pixel + image.channels, is); };
    const bool nan = any([](float value) { return std::isnan(value); });
    faults.nan += nan;
    faults.infinite += !nan && any([](float value) { return std::isinf(value); });
  }
  return faults;
}

void warnOfFaults(const std::string& path, const PixelFaults& faults) {
  if (faults.nan > 0)
    warn(path, "finite pixels", fmt::format("{} that are not numbers", faults.nan),
         "there are no figures of what is compared with them");
  if (faults.infinite > 0)
    warn(path, "finite pixels", fmt::format("{} infinite ones", faults.infinite),
         "they count as white; there is no relMSE");
}

io::Image readChecked(const PictureSet& pictures, const std::string& path, PixelFaults& faults) {
  io::Image image = pictures.read(path);
  faults = faultsOf(image);
  warnOfFaults(path, faults);
  return image;
}

std::vector<std::string> referencePaths(const std::string& text) {
  std::vector<std::string> paths = splitReference(text);
  for (const std::string& path : paths)
    if (isEncoded(path)) refuse("compare", "--reference", "a linear image", path);
  return paths;
}

io::Reference readReference(const PictureSet& pictures, const std::vector<std::string>& paths) {
  io::Reference reference;
  PixelFaults faults;
  reference.a = readChecked(pictures, paths[0], faults);
  if (paths.size() == 1) return reference;
  reference.b = readChecked(pictures, paths[1], faults);
  if (reference.a.pixels == reference.b.pixels)
    warn(paths[1], "another half than " + paths[0], "the same pixels",
         "the unbiased figure is no other than RMSE; render the halves with different seeds");
  return reference;
}

/// A name for the heat map of `imagePath` that no other image of this run has.
std::string heatmapName(const std::string& imagePath, std::set<std::string>& usedNames) {
  const std::string stem = "flip_" + fs::path(imagePath).stem().string();
  std::string name = stem;
  for (int copy = 2; !usedNames.insert(name).second; ++copy) name = fmt::format("{}_{}", stem, copy);
  return name + ".png";
}

std::string heading(const metrics::Metric& metric) {
  return *metric.unit == '\0' ? metric.label : fmt::format("{}/{}", metric.label, metric.unit);
}

std::size_t columnWidth(const metrics::Metric& metric) {
  return std::max(heading(metric).size(), static_cast<std::size_t>(metric.fineWidth));
}

void printTable(const std::vector<ComparedImage>& compared) {
  const std::vector<metrics::Metric>& all = metrics::imageMetrics();
  std::size_t nameWidth = std::string("image").size();
  for (const ComparedImage& item : compared) nameWidth = std::max(nameWidth, item.path.size());
  fmt::print("{:<{}}", "image", nameWidth);
  for (const metrics::Metric& metric : all) fmt::print("  {:>{}}", heading(metric), columnWidth(metric));
  for (const ComparedImage& item : compared) {
    fmt::print("\n{:<{}}", item.path, nameWidth);
    for (std::size_t i = 0; i < all.size(); ++i)
      fmt::print("  {:>{}}", fixed(item.figures.values[i], all[i].fineDigits, "n/a"), columnWidth(all[i]));
  }
  fmt::print("\n");
}

/// Figures that are absent or not finite become null.
void writeReport(const CompareOptions& options, const std::vector<ComparedImage>& compared,
                 const std::optional<double>& temporalError) {
  using Json = nlohmann::ordered_json;
  Json images = Json::array();
  for (const ComparedImage& item : compared) {
    images.push_back({{"image", item.path}, {"non_finite_pixels", item.notFinite}});
    addFigures(images.back(), item.figures);
  }
  const Json report = {{"reference", options.reference},
                       {"images", images},
                       {metrics::kTemporalError.key, number<Json>(temporalError)}};
  writeJson(options.jsonFile, report);
}

void writeHeatmap(const std::string& path, const io::Image& image, bool encoded,
                  const io::Reference& reference) {
  io::writePng(path,
               metrics::colorizeMap(metrics::flipMapToReference(image, encoded, reference.a, reference.b)));
}

/// Says what figures do not cover, or why some are missing.
void printScope(const PictureSet& pictures) {
  const io::PixelWindow& common = pictures.common();
  if (common != pictures.whole())
    fmt::print("compared within {}, which all files cover\n", io::toString(common));
  if (std::min(common.width, common.height) < metrics::kSsimWindowPx)
    fmt::print("no SSIM: smaller than its window of {0}x{0} pixels\n", metrics::kSsimWindowPx);
}

ComparedImage compareImage(const std::string& path, const io::Image& image, const PixelFaults& faults,
                           const io::Reference& reference) {
  ComparedImage compared{path, metrics::compareToReference(image, isEncoded(path), reference.a, reference.b),
                         faults.nan + faults.infinite};
  // Infinite radiance is white, but has no relative error.
  std::optional<double>& relative = compared.figures.values[metrics::indexOfMetric("relmse")];
  if (relative && !std::isfinite(*relative)) relative.reset();
  return compared;
}

void runCompare(const CompareOptions& options) {
  const std::vector<std::string> halves = referencePaths(options.reference);
  std::vector<std::string> paths = halves;
  paths.insert(paths.end(), options.images.begin(), options.images.end());
  const PictureSet pictures(paths, options.size.empty() ? Size{0, 0} : parseSize("compare", options.size));
  const io::Reference reference = readReference(pictures, halves);
  if (!options.heatmapDirectory.empty()) createDirectory("compare", options.heatmapDirectory);
  std::vector<ComparedImage> compared;
  std::set<std::string> heatmapNames;
  metrics::TemporalErrorMeter temporal;
  for (const std::string& path : options.images) {
    PixelFaults faults;
    const io::Image image = readChecked(pictures, path, faults);
    const bool encoded = isEncoded(path);
    compared.push_back(compareImage(path, image, faults, reference));
    temporal.add(encoded ? metrics::clampEncoded(image) : metrics::encodeForDisplay(image));
    if (!options.heatmapDirectory.empty()) {
      const fs::path file = fs::path(options.heatmapDirectory) / heatmapName(path, heatmapNames);
      writeHeatmap(file.string(), image, encoded, reference);
    }
  }
  printTable(compared);
  printScope(pictures);
  if (const auto error = temporal.mean(); error && std::isfinite(*error))
    fmt::print("{} (mean luma difference of consecutive images, for a static view): {:.{}f}\n",
               metrics::kTemporalError.label, *error, metrics::kTemporalError.fineDigits);
  std::fflush(stdout);  // the JSON may go to the same place
  writeReport(options, compared, temporal.mean());
}

}  // namespace

void addCompareCommand(CLI::App& app) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Error figures of images against a converged reference");
  command
      ->add_option("--reference", options->reference,
                   "Linear OpenEXR image or PFM, or two independent halves of it as A.exr,B.exr")
      ->required()
      ->type_name("A.exr[,B.exr]");
  command
      ->add_option(
          "images", options->images,
          "Images to compare, where all files have pixels by their windows: linear OpenEXR, PFM or .raw (RGB "
          "or "
          "RGBA, floats or halves, from the top left on); PNG and display_* hold display-encoded values")
      ->required()
      ->type_name("IMAGE");
  command->add_option("--size", options->size, "Size of raw images; default: that of the reference")
      ->type_name("WIDTHxHEIGHT");
  command->add_option("--json", options->jsonFile, "Write the figures to this file as JSON")
      ->type_name("FILE");
  command
      ->add_option("--heatmap", options->heatmapDirectory,
                   "Write a FLIP picture per image into this directory")
      ->type_name("DIR");
  command->callback([options] { runCompare(*options); });
}

}  // namespace quell::cli
