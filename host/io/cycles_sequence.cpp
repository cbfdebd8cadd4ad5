#include "host/io/cycles_sequence.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/file_error.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {
namespace {

constexpr char kStage[] = "open sequence";
constexpr int kMatrixSide = 4;

FrameFileName filesOf(const char* buffer) {
  return [buffer](int frame) { return fmt::format("{}_{:04}.exr", buffer, frame); };
}

/// Throws std::exception, translated by readCameraFile(), for anything but a 4x4 array of numbers.
Matrix4 toMatrix(const nlohmann::json& rows) {
  Matrix4 matrix{};
  if (rows.size() != kMatrixSide) throw std::invalid_argument("a matrix must have 4 rows");
  for (std::size_t r = 0; r < kMatrixSide; ++r) {
    if (rows.at(r).size() != kMatrixSide) throw std::invalid_argument("a matrix row must have 4 numbers");
    for (std::size_t c = 0; c < kMatrixSide; ++c)
      matrix[kMatrixSide * r + c] = rows.at(r).at(c).get<double>();
  }
  return matrix;
}

}  // namespace

std::map<int, Camera> readCameraFile(const std::string& path) {
  const std::string text = readFile(path);
  std::map<int, Camera> cameras;
  try {
    const nlohmann::json document = nlohmann::json::parse(text);
    for (const nlohmann::json& entry : document.at("frames")) {
      Camera camera;
      camera.worldToClip = toMatrix(entry.at("view_projection"));
      camera.worldToClipPrev = toMatrix(entry.at("previous_view_projection"));
      cameras[entry.at("frame").get<int>()] = camera;
    }
  } catch (const std::exception& error) {
    throwFileError(kStage, path, "frames with view_projection and previous_view_projection", error.what());
  }
  return cameras;
}

CyclesSequence::CyclesSequence(std::string directory, int signals)
    : m_directory(std::move(directory)),
      m_frames(findFrames(m_directory, filesOf("color"))),
      m_signals(signals) {
  const std::string cameraPath = joinPath(m_directory, kCyclesCameraFile);
  m_cameras = readCameraFile(cameraPath);
  for (int frame : m_frames)
    if (m_cameras.count(frame) == 0)
      throwFileError(kStage, cameraPath, fmt::format("matrices of frame {}", frame), "none");
  for (const char* required : {"shading_normal", "world_position"})
    requireFrameFiles(m_directory, filesOf(required), m_frames);
  if (m_signals == 2)
    for (const char* required : {"diffuse_irradiance", "glossy_radiance"})
      requireFrameFiles(m_directory, filesOf(required), m_frames);
  m_hasAlbedo = hasFrameFiles(m_directory, filesOf("albedo"), m_frames);
  m_hasGlossColor = hasFrameFiles(m_directory, filesOf("gloss_color"), m_frames);
  m_hasEmission = hasFrameFiles(m_directory, filesOf("emission"), m_frames);
  m_hasRoughness = hasFrameFiles(m_directory, filesOf("roughness"), m_frames);
  m_hasF0 = hasFrameFiles(m_directory, filesOf("f0"), m_frames);
  m_hasMotion = hasFrameFiles(m_directory, filesOf("motion"), m_frames);
  m_hasObjectId = hasFrameFiles(m_directory, filesOf("object_id"), m_frames);

  const ExrHeader first = readExrHeader(joinPath(m_directory, filesOf("color")(m_frames.front())));
  m_width = first.width;
  m_height = first.height;
}

Image CyclesSequence::readBuffer(const char* buffer, int frame) const {
  return readRgbOfSize(joinPath(m_directory, filesOf(buffer)(frame)), m_width, m_height);
}

Image CyclesSequence::readChannels(const char* buffer, const std::vector<std::string>& channels,
                                   int frame) const {
  return readChannelsOfSize(joinPath(m_directory, filesOf(buffer)(frame)), channels, m_width, m_height);
}

FrameData CyclesSequence::read(int frame) const {
  requireFrame(m_directory, m_frames, frame);
  FrameData data;
  data.number = frame;
  data.camera = m_cameras.at(frame);
  Image color = readBuffer("color", frame);
  if (m_signals == 2) {
    data.combined = std::move(color);
    data.radiance = readBuffer("diffuse_irradiance", frame);
    data.glossyRadiance = readBuffer("glossy_radiance", frame);
    data.demodulated = true;
  } else {
    data.radiance = std::move(color);
  }
  data.normalWorld = readBuffer("shading_normal", frame);
  data.positionWorld = readBuffer("world_position", frame);
  if (m_hasAlbedo) data.albedo = readBuffer("albedo", frame);
  if (m_hasGlossColor) data.glossColor = readBuffer("gloss_color", frame);
  if (m_hasEmission) data.emission = readBuffer("emission", frame);
  if (m_hasF0) data.f0 = readBuffer("f0", frame);
  if (m_hasRoughness) data.roughness = readChannels("roughness", {"Y"}, frame);
  if (m_hasMotion) data.motion = readChannels("motion", {"R", "G"}, frame);
  if (m_hasObjectId) data.objectId = readChannels("object_id", {"Y"}, frame);
  return data;
}

std::optional<Reference> CyclesSequence::reference(int frame) const {
  requireFrame(m_directory, m_frames, frame);
  const auto hasHalf = [&](const char* buffer) { return hasFile(m_directory, filesOf(buffer)(frame)); };
  if (!hasHalf("ref_a_color")) return std::nullopt;
  Reference reference;
  reference.a = readBuffer("ref_a_color", frame);
  if (hasHalf("ref_b_color")) reference.b = readBuffer("ref_b_color", frame);
  return reference;
}

}  // namespace quell::io
