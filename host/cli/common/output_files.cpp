#include "host/cli/common/output_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "host/io/png_image.hpp"
#include "host/metrics/display_encoding.hpp"
#include "host/metrics/error.hpp"

namespace quell::cli {
namespace {

// Of what was left out, in the picture of tiles.
constexpr float kBackgroundBrightness = 0.3f;

void paste(io::Image& target, const io::Image& source, int column) {
  for (int y = 0; y < source.height; ++y)
    for (int x = 0; x < source.width; ++x)
      for (int c = 0; c < 3; ++c) target.at(column + x, y, c) = source.at(x, y, c);
}

std::vector<std::string> planeNames(int planes) {
  if (planes == 1) return {"Y"};
  if (planes == 3) return {"R", "G", "B"};
  std::vector<std::string> names;
  for (int plane = 0; plane < planes; ++plane) names.push_back(fmt::format("plane{}", plane));
  return names;
}

void writePicture(const std::string& path, const io::Image& picture, const io::FrameData& frame,
                  io::ExrType samples) {
  if (frame.alpha.empty()) return io::writeExr(path, picture, {"R", "G", "B"}, samples, frame.origin);
  io::Image image(picture.width, picture.height, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = i % 4 == 3 ? frame.alpha.pixels[i / 4] : picture.pixels[i / 4 * 3 + i % 4];
  io::writeExr(path, image, {"R", "G", "B", "A"}, samples, frame.origin);
}

}  // namespace

void createDirectory(const char* command, const std::string& path) {
  std::error_code failure;
  std::filesystem::create_directories(path, failure);
  if (failure)
    throw Error(ErrorCode::FileError,
                {command, path, "a directory that can be created or exists", failure.message()});
}

OutputFiles::OutputFiles(std::string directory, OutputFormats formats)
    : m_directory(std::move(directory)), m_formats(formats) {
  createDirectory("denoise", m_directory);
}

std::string OutputFiles::path(const std::string& prefix, int frame, const char* extension) const {
  return (std::filesystem::path(m_directory) /
          fmt::format("{}_{}.{}", prefix, io::paddedFrame(frame), extension))
      .string();
}

void OutputFiles::write(const io::FrameData& frame, const DenoisedFrame& denoised) const {
  writePicture(path("denoised", frame.number, "exr"), denoised.linear, frame, m_formats.samples);
  if (m_formats.png) io::writePng(path("display", frame.number, "png"), denoised.display);
  if (m_formats.exr)
    writePicture(path("display", frame.number, "exr"), denoised.display, frame, m_formats.samples);
}

void OutputFiles::writeLinear(const std::string& prefix, const io::FrameData& frame,
                              const io::Image& picture) const {
  writePicture(path(prefix, frame.number, "exr"), picture, frame, m_formats.samples);
}

void OutputFiles::writeComparison(const io::FrameData& noisy, const DenoisedFrame& denoised,
                                  const io::Reference& reference) const {
  io::writePng(path("comparison", noisy.number, "png"), comparisonSheet(noisy.noisy(), denoised, &reference));
}

void OutputFiles::writeBuffer(int frame, const BufferContent& content) const {
  io::Image image(content.width, content.height, content.planes);
  const std::size_t pixels = image.pixels.size() / std::size_t(image.channels);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i % pixels * std::size_t(image.channels) + i / pixels] = content.values[i];
  io::writeExr(path(content.name, frame, "exr"), image, planeNames(content.planes), io::ExrType::Float);
}

void OutputFiles::writeTiles(int frame, const DenoisedFrame& denoised, const BackgroundMap& map) const {
  io::Image picture = denoised.display;
  for (int y = 0; y < picture.height && !map.background.empty(); ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int item = y * map.columns + x / map.itemWidth;
      if (map.background[static_cast<std::size_t>(item)] == 0) continue;
      for (int c = 0; c < 3; ++c) picture.at(x, y, c) *= kBackgroundBrightness;
    }
  }
  io::writePng(path("tiles", frame, "png"), picture);
}

io::Image comparisonSheet(const io::Image& noisy, const DenoisedFrame& denoised,
                          const io::Reference* reference) {
  const int width = denoised.display.width;
  const auto shown = [&](const io::Image& linear) {
    return metrics::encodeForDisplay(linear, denoised.transform);
  };
  io::Image sheet((reference != nullptr ? 3 : 2) * width, denoised.display.height, 3);
  paste(sheet, shown(noisy), 0);
  paste(sheet, denoised.display, width);
  if (reference != nullptr) paste(sheet, shown(metrics::meanOfHalves(reference->a, reference->b)), 2 * width);
  return sheet;
}

}  // namespace quell::cli
