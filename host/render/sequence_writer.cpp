#include "host/render/sequence_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <quell/error.hpp>
#include <utility>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/file_error.hpp"

namespace quell::render {
namespace {

using nlohmann::json;

constexpr char kStage[] = "render";
constexpr char kSettingsFile[] = "render.json";
constexpr char kCameraFile[] = "camera.json";
/// Grows when the same settings no longer give the same pixels.
constexpr int kRendererVersion = 1;

const std::vector<std::string>& frameBuffers() {
  static const std::vector<std::string> names = {
      "diffuse_irradiance", "glossy_radiance", "albedo",         "gloss_color", "f0",
      "emission",           "shading_normal",  "world_position", "roughness",   "object_id",
      "hit_distance",       "motion",          "color"};
  return names;
}

std::vector<std::string> referenceBuffers(char half) {
  std::vector<std::string> names;
  for (const char* buffer : {"diffuse_irradiance", "glossy_radiance", "color"})
    names.push_back(fmt::format("ref_{}_{}", half, buffer));
  return names;
}

std::string joined(const std::string& directory, const std::string& name) {
  return (std::filesystem::path(directory) / name).string();
}

bool isWhole(const std::string& path, Size size) {
  try {
    const io::Image image = io::readExr(path);
    return image.width == size.width && image.height == size.height;
  } catch (const Error&) {
    return false;
  }
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
          {"height", settings.size.height}, {"samples", settings.samples}, {"seed", settings.seed}};
}

json readSettings(const std::string& path) {
  if (!std::filesystem::exists(path)) return nullptr;
  try {
    return json::parse(io::readFile(path));
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

std::string SequenceWriter::path(const std::string& buffer, int frame) const {
  return joined(m_directory, fmt::format("{}_{:04}.exr", buffer, frame));
}

void SequenceWriter::writeCameras(const SceneEntry& scene, int frameCount) const {
  json frames = json::array();
  const auto matrixAt = [&](int frame) {
    return rowsOf(worldToClip(makeScene(scene, frame).camera, m_settings.size.width, m_settings.size.height));
  };
  json previous = matrixAt(-1);
  for (int frame = 0; frame < frameCount; ++frame) {
    json current = matrixAt(frame);
    frames.push_back(
        {{"frame", frame}, {"view_projection", current}, {"previous_view_projection", std::move(previous)}});
    previous = std::move(current);
  }
  const json document = {
      {"width", m_settings.size.width}, {"height", m_settings.size.height}, {"frames", std::move(frames)}};
  io::writeTextFile(joined(m_directory, kCameraFile), document.dump(1) + "\n");
}

bool SequenceWriter::areWhole(const std::vector<std::string>& buffers, int frame) const {
  return std::all_of(buffers.begin(), buffers.end(), [&](const std::string& buffer) {
    return isWhole(path(buffer, frame), m_settings.size);
  });
}

bool SequenceWriter::hasFrame(int frame) const { return areWhole(frameBuffers(), frame); }

bool SequenceWriter::hasReference(int frame, char half) const {
  return areWhole(referenceBuffers(half), frame);
}

void SequenceWriter::writeFrame(int frame, const Features& features, const Light& light) const {
  const auto write = [&](const char* buffer, const io::Image& image, io::ExrType type = io::ExrType::Half) {
    io::writeExr(path(buffer, frame), image, type);
  };
  write("diffuse_irradiance", light.diffuse);
  write("glossy_radiance", light.glossy);
  write("albedo", features.albedo);
  write("gloss_color", features.glossColor);
  write("f0", features.f0);
  write("emission", features.emission);
  write("shading_normal", features.normal);
  write("world_position", features.position, io::ExrType::Float);
  write("roughness", features.roughness);
  write("motion", features.motion);
  write("object_id", features.objectId, io::ExrType::Uint);
  write("hit_distance", light.hitDistance);
  write("color", composeColor(features, light));
}

void SequenceWriter::writeReference(int frame, char half, const Features& features,
                                    const Light& light) const {
  const auto write = [&](const char* buffer, const io::Image& image) {
    io::writeExr(path(fmt::format("ref_{}_{}", half, buffer), frame), image);
  };
  write("diffuse_irradiance", light.diffuse);
  write("glossy_radiance", light.glossy);
  write("color", composeColor(features, light));
}

}  // namespace quell::render
