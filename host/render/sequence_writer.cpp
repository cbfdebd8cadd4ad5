#include "host/render/sequence_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <quell/error.hpp>
#include <utility>
#include <vector>

#include "host/io/atomic_file.hpp"
#include "host/io/camera_keys.hpp"
#include "host/io/cycles_sequence.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/file_error.hpp"
#include "host/io/halton.hpp"
#include "host/io/image_sources.hpp"

namespace quell::render {
namespace {

using nlohmann::json;

constexpr char kStage[] = "render";
constexpr char kSettingsFile[] = "render.json";
constexpr char kJitterSetting[] = "jitter";
/// Grows when the same settings no longer give the same pixels.
constexpr int kRendererVersion = 1;

/// The images of a frame that are written; the path tracer makes all that have files.
std::vector<io::ImageSource> frameImages() {
  std::vector<io::ImageSource> images;
  for (const io::ImageSource& image : io::imageSources(2))
    if (image.files.stem[0] != '\0') images.push_back(image);
  return images;
}

// Of the antialiased kind the picture alone: over an edge, light apart from material means nothing.
std::vector<io::ImageSource> referenceImages(io::ReferenceKind kind) {
  const bool parts = kind == io::ReferenceKind::Centre;
  std::vector<io::ImageSource> images;
  for (const io::ImageSource& image : io::imageSources(2))
    if (image.image == &io::FrameData::combined ||
        (parts && (image.image == &io::FrameData::radiance || image.image == &io::FrameData::glossyRadiance)))
      images.push_back(image);
  return images;
}

std::string joined(const std::string& directory, const std::string& name) {
  return (std::filesystem::path(directory) / name).string();
}

json rowsOf(const Matrix4& matrix) {
  json rows = json::array();
  for (std::size_t row = 0; row < 4; ++row)
    rows.push_back({matrix[4 * row], matrix[4 * row + 1], matrix[4 * row + 2], matrix[4 * row + 3]});
  return rows;
}

/// What must be equal for frames to belong to one sequence.
json identity(const SequenceSettings& settings) {
  return {{"renderer", kRendererVersion},   {"scene", settings.scene},     {"width", settings.size.width},
          {"height", settings.size.height}, {"samples", settings.samples}, {"seed", settings.seed},
          {kJitterSetting, settings.jitter}};
}

json readSettings(const std::string& path) {
  if (!std::filesystem::exists(path)) return nullptr;
  try {
    json settings = json::parse(io::readFile(path));
    settings.emplace(kJitterSetting, false);  // of directories that are older than jitter
    return settings;
  } catch (const json::exception& error) {
    io::throwFileError(kStage, path, "the settings of a rendering", error.what());
  }
}

[[noreturn]] void refuse(const std::string& path, const json& expected, const json& got) {
  throw Error(ErrorCode::InvalidArgument,
              {kStage, path, "an empty directory, or one rendered with " + expected.dump(), got.dump()});
}

}  // namespace

SequenceWriter::SequenceWriter(std::string directory, const SequenceSettings& settings, int frameCount)
    : m_directory(std::move(directory)), m_settings(settings) {
  const SceneEntry& scene = findScene(settings.scene);
  std::error_code failure;
  std::filesystem::create_directories(m_directory, failure);
  if (failure)
    io::throwFileError(kStage, m_directory, "a directory that can be created or exists", failure.message());
  const std::string path = joined(m_directory, kSettingsFile);
  const json before = readSettings(path);
  json now = identity(settings);
  for (const auto& [key, value] : now.items())
    if (!before.is_null() && before.value(key, json()) != value) refuse(path, now, before);
  const json oldReference = before.is_null() ? json(0) : before.value("reference_samples", json(0));
  if (settings.referenceSamples > 0 && oldReference != 0 && oldReference != settings.referenceSamples)
    refuse(path, {{"reference_samples", settings.referenceSamples}}, before);
  now["reference_samples"] = settings.referenceSamples > 0 ? json(settings.referenceSamples) : oldReference;
  const int frames = before.is_null() ? frameCount : std::max(frameCount, before.value("frames", 0));
  now["frames"] = frames;
  io::writeTextFile(path, now.dump(1) + "\n");
  writeCameras(scene, frames);
}

std::string SequenceWriter::path(const std::string& stem, int frame) const {
  return joined(m_directory, fmt::format("{}_{:04}.exr", stem, frame));
}

void SequenceWriter::writeCameras(const SceneEntry& scene, int frameCount) const {
  using Key = io::CameraKey;
  json frames = json::array();
  const auto matrixAt = [&](int frame) {
    return rowsOf(worldToClip(makeScene(scene, frame).camera, m_settings.size.width, m_settings.size.height));
  };
  json previous = matrixAt(-1);
  for (int frame = 0; frame < frameCount; ++frame) {
    json current = matrixAt(frame);
    frames.push_back({{nameOf(Key::Frame), frame},
                      {nameOf(Key::ViewProjection), current},
                      {nameOf(Key::PreviousViewProjection), std::move(previous)}});
    if (m_settings.jitter) frames.back()[nameOf(Key::JitterPx)] = io::jitterPxOf(frame);
    previous = std::move(current);
  }
  const json document = {{"width", m_settings.size.width},
                         {"height", m_settings.size.height},
                         {nameOf(Key::Frames), std::move(frames)}};
  io::writeTextFile(joined(m_directory, io::kCyclesCameraFile), document.dump(1) + "\n");
}

bool SequenceWriter::isWhole(const std::string& stem, int frame) const {
  try {
    const io::Image image = io::readExr(path(stem, frame));
    return image.width == m_settings.size.width && image.height == m_settings.size.height;
  } catch (const Error&) {
    return false;
  }
}

bool SequenceWriter::hasFrame(int frame) const {
  const auto images = frameImages();
  return std::all_of(images.begin(), images.end(),
                     [&](const io::ImageSource& image) { return isWhole(image.files.stem, frame); });
}

bool SequenceWriter::hasReference(int frame, io::ReferenceKind kind, char half) const {
  const auto images = referenceImages(kind);
  return std::all_of(images.begin(), images.end(), [&](const io::ImageSource& image) {
    return isWhole(io::referenceStem(kind, half, image.files.stem), frame);
  });
}

void SequenceWriter::writeFrame(int frame, const io::FrameData& data) const {
  for (const io::ImageSource& image : frameImages())
    io::writeImage(path(image.files.stem, frame), data.*image.image, image.files);
}

void SequenceWriter::writeReference(int frame, io::ReferenceKind kind, char half,
                                    const io::FrameData& data) const {
  for (const io::ImageSource& image : referenceImages(kind))
    io::writeImage(path(io::referenceStem(kind, half, image.files.stem), frame), data.*image.image,
                   image.files);
}

}  // namespace quell::render
