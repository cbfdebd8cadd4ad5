// quell compare: error figures of images against a converged reference.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <quell/error.hpp>
#include <set>
#include <string>
#include <vector>

#include "host/cli/common/commands.hpp"
#include "host/cli/common/figures.hpp"
#include "host/cli/common/output_files.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/frame_sequence.hpp"
#include "host/io/png_image.hpp"
#include "host/metrics/color_map.hpp"
#include "host/metrics/display_encoding.hpp"
#include "host/metrics/report.hpp"
#include "host/metrics/temporal.hpp"

namespace quell::cli {
namespace {

namespace fs = std::filesystem;

struct CompareOptions {
  std::string reference;  // A.exr or A.exr,B.exr
  std::vector<std::string> images;
  std::string jsonFile;
  std::string heatmapDirectory;
};

struct ComparedImage {
  std::string path;
  metrics::ErrorFigures figures;
};

bool isPng(const std::string& path) {
  const std::string extension = fs::path(path).extension().string();
  return extension == ".png" || extension == ".PNG";
}

/// By name: pictures, and what the denoise command writes for display, hold encoded values; the rest is
/// linear.
bool isEncoded(const std::string& path) {
  return isPng(path) || fs::path(path).filename().string().rfind("display_", 0) == 0;
}

io::Image readImage(const std::string& path) {
  return isPng(path) ? io::readPng(path) : io::readExrRgb(path);
}

io::Image readReferenceHalf(const std::string& path) {
  if (!isEncoded(path)) return io::readExrRgb(path);
  throw Error(ErrorCode::InvalidArgument, {"compare", "--reference", "a linear OpenEXR image", path});
}

/// Throws unless `text` is one or two file names joined by a comma.
io::Reference readReference(const std::string& text) {
  const std::size_t comma = text.find(',');
  io::Reference reference;
  reference.a = readReferenceHalf(text.substr(0, comma));
  if (comma == std::string::npos) return reference;
  const std::string second = text.substr(comma + 1);
  reference.b = readReferenceHalf(second);
  io::requireSize(reference.b, reference.a.width, reference.a.height, second);
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
  for (const auto& [path, figures] : compared) {
    images.push_back({{"image", path}});
    addFigures(images.back(), figures);
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

void runCompare(const CompareOptions& options) {
  const io::Reference reference = readReference(options.reference);
  if (!options.heatmapDirectory.empty()) createDirectory("compare", options.heatmapDirectory);
  std::vector<ComparedImage> compared;
  std::set<std::string> heatmapNames;
  metrics::TemporalErrorMeter temporal;
  for (const std::string& path : options.images) {
    const io::Image image = readImage(path);
    const bool encoded = isEncoded(path);
    io::requireSize(image, reference.a.width, reference.a.height, path);
    compared.push_back({path, metrics::compareToReference(image, encoded, reference.a, reference.b)});
    temporal.add(encoded ? metrics::clampEncoded(image) : metrics::encodeForDisplay(image));
    if (!options.heatmapDirectory.empty()) {
      const fs::path file = fs::path(options.heatmapDirectory) / heatmapName(path, heatmapNames);
      writeHeatmap(file.string(), image, encoded, reference);
    }
  }
  printTable(compared);
  if (const auto error = temporal.mean())
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
                   "Linear OpenEXR image, or two independent halves of it as A.exr,B.exr")
      ->required()
      ->type_name("A.exr[,B.exr]");
  command
      ->add_option("images", options->images,
                   "Images to compare: linear OpenEXR; PNG and display_* hold display-encoded values")
      ->required()
      ->type_name("IMAGE");
  command->add_option("--json", options->jsonFile, "Write the figures to this file as JSON")
      ->type_name("FILE");
  command
      ->add_option("--heatmap", options->heatmapDirectory,
                   "Write a FLIP picture per image into this directory")
      ->type_name("DIR");
  command->callback([options] { runCompare(*options); });
}

}  // namespace quell::cli
