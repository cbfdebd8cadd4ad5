#include "host/io/cycles_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/file_error.hpp"
#include "host/io/light_remainder.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {
namespace {

constexpr char kStage[] = "open sequence";
constexpr int kMatrixSide = 4;

constexpr ImageFiles kColor = factsOf(&FrameData::radiance).files;

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

/// Throws std::exception, too, for anything but two numbers; what they are is checked by requireJitter().
std::array<double, 2> toJitter(const nlohmann::json& numbers) {
  if (numbers.size() != 2) throw std::invalid_argument("jitter_px must have 2 numbers");
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>()};
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
      if (entry.contains(kJitterKey)) camera.jitterPx = toJitter(entry[kJitterKey]);
      cameras[entry.at("frame").get<int>()] = camera;
    }
  } catch (const std::exception& error) {
    throwFileError(kStage, path, "frames with view_projection and previous_view_projection", error.what());
  }
  for (const auto& [frame, camera] : cameras) requireJitter(path, kJitterKey, frame, camera.jitterPx);
  return cameras;
}

CyclesSequence::CyclesSequence(std::string directory, int signals, MissingFrames missing, FrameFiles colors)
    : m_directory(std::move(directory)), m_files(m_directory), m_demodulated(signals == 2) {
  const std::string cameraPath = joinPath(m_directory, kCyclesCameraFile);
  m_cameras = readCameraFile(cameraPath);
  std::vector<FrameFiles> required = {colors.empty() ? filesOf(kColor.stem) : std::move(colors)};
  for (const ImageSource& source : imageSources(signals))
    if (source.required) required.push_back(filesOf(source.files.stem));
  m_frames = framesOf(required, missing);
  for (int frame : m_frames)
    if (m_cameras.count(frame) == 0)
      throwFileError(kStage, cameraPath, fmt::format("matrices of frame {}", frame), "none");
  for (const ImageSource& source : imageSources(signals))
    if (source.files.stem[0] != '\0' && (source.required || hasAll(filesOf(source.files.stem), m_frames)))
      m_sources.push_back(source);

  const ExrHeader first = readExrHeader(required.front().path(m_frames.front()));
  m_hasAlpha = std::count(first.channels.begin(), first.channels.end(), "A") > 0;
  m_windows = first.windows;
}

const FrameFiles& CyclesSequence::filesOf(const std::string& stem) const {
  return m_files.withPrefix(stem + "_");
}

Image CyclesSequence::readImage(const std::string& stem, const char* channels, int frame,
                                std::vector<FrameWarning>& warnings) const {
  return readLettersWithin(filesOf(stem).path(frame), channels, m_windows, warnings);
}

FrameData CyclesSequence::read(int frame) const {
  requireFrame(m_directory, m_frames, frame);
  FrameData data;
  data.number = frame;
  markGap(data, m_frames, filesOf(kColor.stem).path(frame - 1));
  data.origin = originOf(filesOf(kColor.stem).path(frame), m_windows);
  data.camera = cropped(m_cameras.at(frame), m_windows);
  data.demodulated = m_demodulated;
  for (const ImageSource& source : m_sources)
    data.*source.image = readImage(source.files.stem, source.files.channels, frame, data.warnings);
  if (m_hasAlpha) data.alpha = readImage(kColor.stem, "A", frame, data.warnings);
  if (m_demodulated) keepRemainder(data, Image());
  return data;
}

std::string CyclesSequence::fileOf(int frame, const ImageFiles& files) const {
  return filesOf(files.stem).path(frame);
}

std::vector<std::string> CyclesSequence::describeChannels() const {
  ChannelMap map;
  map.renderer = "quell";
  for (const ImageSource& source : m_sources) map.images[source.files.role] = {{{source.files.stem}}, {}};
  return describe(map);
}

bool CyclesSequence::jittered() const {
  return std::any_of(m_frames.begin(), m_frames.end(),
                     [this](int frame) { return isJittered(m_cameras.at(frame)); });
}

bool CyclesSequence::hasReference(int frame, ReferenceKind kind) const {
  return filesOf(referenceStem(kind, 'a', kColor.stem)).has(frame);
}

Reference CyclesSequence::reference(int frame, ReferenceKind kind) const {
  requireReference(*this, frame, kind);
  const auto stem = [kind](char half) { return referenceStem(kind, half, kColor.stem); };
  std::vector<FrameWarning> unheard;  // a reference is looked at for figures, not for its frame
  Reference reference{readImage(stem('a'), kColor.channels, frame, unheard), {}, kind};
  if (filesOf(stem('b')).has(frame)) reference.b = readImage(stem('b'), kColor.channels, frame, unheard);
  return reference;
}

}  // namespace quell::io
