#include "host/io/bmfr_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host/io/atomic_file.hpp"
#include "host/io/c_header_values.hpp"
#include "host/io/file_error.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {
namespace {

constexpr char kStage[] = "open sequence";
constexpr std::size_t kMatrixSide = 4;
constexpr std::size_t kMatrixSize = kMatrixSide * kMatrixSide;
constexpr std::size_t kOffsetSize = 2;
constexpr std::size_t kClipRowY = 1;
/// Where the published pixel offset of a ray through the pixel centre lies, pixels.
constexpr double kCentreOffsetPx = 0.5;

// The images of a frame; all are there.
constexpr Image FrameData::*kImages[] = {&FrameData::radiance, &FrameData::normalWorld,
                                         &FrameData::positionWorld, &FrameData::albedo};

constexpr char kReferenceStem[] = "reference";

/// From m[column][row] with y down to row-major with y up.
Matrix4 toQuellConvention(const double* published) {
  Matrix4 matrix{};
  for (std::size_t row = 0; row < kMatrixSide; ++row)
    for (std::size_t column = 0; column < kMatrixSide; ++column)
      matrix[kMatrixSide * row + column] =
          (row == kClipRowY ? -1.0 : 1.0) * published[kMatrixSide * column + row];
  return matrix;
}

/// An array of `itemSize` numbers per frame for frames 0 to lastFrame at least.
std::vector<double> requireArray(const CHeaderValues& header, const std::string& path,
                                 const std::string& name, std::size_t itemSize, int lastFrame) {
  const auto values = header.array(name);
  if (!values) throwFileError(kStage, path, "an array " + name, "no such name");
  if (values->size() % itemSize != 0)
    throwFileError(kStage, path, fmt::format("{} numbers per frame in {}", itemSize, name),
                   fmt::format("{} numbers in all", values->size()));
  if (values->size() / itemSize <= std::size_t(lastFrame))
    throwFileError(kStage, path, fmt::format("{} of frames 0 to {}", name, lastFrame),
                   fmt::format("{} frames", values->size() / itemSize));
  return *values;
}

std::optional<HistoryLimits> readLimits(const CHeaderValues& header, const std::string& path) {
  const auto position = header.constant("position_limit_squared");
  const auto normal = header.constant("normal_limit_squared");
  if (!position && !normal) return std::nullopt;
  if (!position || !normal)
    throwFileError(kStage, path, "both position_limit_squared and normal_limit_squared, or neither", "one");
  if (*position <= 0.0 || *normal <= 0.0)
    throwFileError(kStage, path, "limits above zero",
                   fmt::format("position_limit_squared {}, normal_limit_squared {}", *position, *normal));
  return HistoryLimits{*position, *normal};
}

}  // namespace

BmfrSequence::BmfrSequence(std::string directory, MissingFrames missing, FrameFiles colors)
    : m_directory(std::move(directory)), m_files(m_directory) {
  std::vector<FrameFiles> required;
  for (const auto image : kImages) required.push_back(filesOf(factsOf(image).files));
  if (!colors.empty()) required.front() = std::move(colors);
  m_frames = framesOf(required, missing);
  if (m_frames.front() < 0)
    throwFileError(kStage, required.front().path(m_frames.front()), "frames from 0, as the matrices have",
                   std::to_string(m_frames.front()));
  readCameraHeader();
  const ExrHeader first = readExrHeader(required.front().path(m_frames.front()));
  m_windows = first.windows;
}

const FrameFiles& BmfrSequence::filesOf(const ImageFiles& files) const {
  return m_files.withPrefix(files.stem);
}

void BmfrSequence::readCameraHeader() {
  const std::string path = joinPath(m_directory, kBmfrCameraFile);
  const CHeaderValues header(readFile(path), path);
  const auto matrices = requireArray(header, path, "camera_matrices", kMatrixSize, m_frames.back());
  const auto offsets = requireArray(header, path, "pixel_offsets", kOffsetSize, m_frames.back());
  for (std::size_t i = 0; i < matrices.size(); i += kMatrixSize)
    m_worldToClip.push_back(toQuellConvention(&matrices[i]));
  for (std::size_t i = 0; i < offsets.size(); i += kOffsetSize)
    m_jitterPx.push_back(requireJitter(path, "pixel_offsets", int(m_jitterPx.size()),
                                       {offsets[i] - kCentreOffsetPx, kCentreOffsetPx - offsets[i + 1]}));
  m_limits = readLimits(header, path);
}

Camera BmfrSequence::cameraOf(int frame) const {
  Camera camera;
  camera.worldToClip = m_worldToClip[std::size_t(frame)];
  camera.worldToClipPrev = m_worldToClip[std::size_t(std::max(frame - 1, 0))];
  camera.jitterPx = m_jitterPx[std::size_t(frame)];
  return camera;
}

bool BmfrSequence::jittered() const {
  return std::any_of(m_frames.begin(), m_frames.end(),
                     [this](int frame) { return isJittered(cameraOf(frame)); });
}

FrameData BmfrSequence::read(int frame) const {
  requireFrame(m_directory, m_frames, frame);
  FrameData data;
  data.number = frame;
  markGap(data, m_frames, fileOf(frame - 1, factsOf(&FrameData::radiance).files));
  OpenFiles opened;
  data.origin = originOf(opened.at(fileOf(frame, factsOf(&FrameData::radiance).files)), m_windows);
  data.camera = cropped(cameraOf(frame), m_windows);
  for (const auto image : kImages) {
    const ImageFiles& files = factsOf(image).files;
    data.*image = readWithin(opened.at(fileOf(frame, files)), channelsOfLetters(files.channels), m_windows,
                             data.warnings);
  }
  data.demodulated = true;
  return data;
}

void BmfrSequence::requireReadable(const std::vector<int>& frames) const {
  for (const int frame : frames) {
    OpenFiles opened;
    originOf(opened.whole(fileOf(frame, factsOf(&FrameData::radiance).files)), m_windows);
    for (const auto image : kImages) {
      const ImageFiles& files = factsOf(image).files;
      requireWithin(opened.whole(fileOf(frame, files)), channelsOfLetters(files.channels), m_windows);
    }
    if (const FrameFiles& references = m_files.withPrefix(kReferenceStem); references.has(frame))
      requireWithin(opened.whole(references.path(frame)), channelsOfLetters("RGB"), m_windows);
  }
}

std::string BmfrSequence::fileOf(int frame, const ImageFiles& files) const {
  return filesOf(files).path(frame);
}

bool BmfrSequence::hasReference(int frame, ReferenceKind kind) const {
  const ReferenceKind published = jittered() ? ReferenceKind::Antialiased : ReferenceKind::Centre;
  return kind == published && m_files.withPrefix(kReferenceStem).has(frame);
}

Reference BmfrSequence::reference(int frame, ReferenceKind kind) const {
  requireReference(*this, frame, kind);
  std::vector<FrameWarning> unheard;  // a reference is looked at for figures, not for its frame
  const ExrFile file(m_files.withPrefix(kReferenceStem).path(frame));
  return {readWithin(file, channelsOfLetters("RGB"), m_windows, unheard), {}, kind};
}

}  // namespace quell::io
