#include "host/io/multilayer_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "host/io/cycles_sequence.hpp"
#include "host/io/exr_camera.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/file_error.hpp"
#include "host/io/image_sources.hpp"
#include "host/io/light_remainder.hpp"
#include "host/io/multilayer_camera.hpp"
#include "host/io/position_depth.hpp"
#include "host/io/ray_depth.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {
namespace {

namespace fs = std::filesystem;

constexpr char kStage[] = "open sequence";
constexpr char kCycles[] = "cycles";
// Images that cameras are found from.
constexpr const char* kPosition = factsOf(&FrameData::positionWorld).files.role;
constexpr const char* kNormal = factsOf(&FrameData::normalWorld).files.role;
constexpr const char* kDepth = factsOf(&FrameData::viewDepth).files.role;
constexpr const char* kMotion = factsOf(&FrameData::motion).files.role;
constexpr char kAlpha[] = "alpha";
constexpr char kTransmission[] = "transmission_color";

/// Blender's background has no motion, whatever the camera does: better no history there.
void withoutBackground(Image& motion, const Image& normal) {
  for (std::size_t pixel = 0; pixel < normal.pixels.size() / 3; ++pixel) {
    const float* n = &normal.pixels[3 * pixel];
    if (n[0] == 0.0f && n[1] == 0.0f && n[2] == 0.0f)
      motion.pixels[2 * pixel + 1] = std::numeric_limits<float>::quiet_NaN();
  }
}

/// Whether a file has channels of color, normal, and position or depth; nothing where it cannot be read.
std::optional<bool> hasPasses(const std::string& path, const ChannelOptions& options) {
  try {
    const ExrHeader header = readExrHeader(path);
    return hasFrameChannels(header.channels, header.views, options);
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<FrameFiles> withoutReferences(std::vector<FrameFiles> sequences) {
  const auto first = std::stable_partition(sequences.begin(), sequences.end(), [](const FrameFiles& files) {
    return !isReferenceName(files.prefix());
  });
  if (first != sequences.begin()) sequences.erase(first, sequences.end());
  return sequences;
}

FrameFiles findMultilayerFiles(const std::string& directory, const ChannelOptions& options) {
  std::vector<FrameFiles> found;
  for (FrameFiles& files : withoutReferences(FrameDirectory(directory).all())) {
    const std::vector<int> frames = files.frames();
    // The first whose header can be read speaks for all.
    std::optional<bool> multilayer;
    for (std::size_t i = 0; i < frames.size() && !multilayer; ++i)
      multilayer = hasPasses(files.path(frames[i]), options);
    if (multilayer.value_or(false)) found.push_back(std::move(files));
  }
  return found.empty() ? FrameFiles() : requireOneSequence(directory, found);
}

MultilayerSequence::MultilayerSequence(std::string name, std::vector<PassFiles> passes,
                                       const SequenceOptions& options)
    : m_name(std::move(name)),
      m_files(m_name, std::move(passes), options.channels, options.missing),
      m_signals(options.signals) {
  m_headerCameras = !headerCameras(readExrHeader(m_files.fileOf(m_files.frames().front()))).empty();
  openCameras(m_files.directory());
  requireImages();
}

void MultilayerSequence::openCameras(const std::string& directory) {
  // Beside the folders where each pass has one.
  for (const std::string& place : {directory.empty() ? std::string(".") : directory, m_name}) {
    if (!m_cameras.empty() || !hasFile(place, kCyclesCameraFile)) continue;
    m_cameras = DeclaredCameras(joinPath(place, kCyclesCameraFile), m_files.windows(), m_files.frames());
  }
}

void MultilayerSequence::requireImages() const {
  for (const ImageSource& source : imageSources(m_signals))
    if (source.required && source.image != &FrameData::positionWorld) m_files.require(source.files.role);
  // The light of two signals is divided by these.
  if (m_signals == 2)
    for (const char* factor : {"albedo", "gloss_color"}) m_files.require(factor);
  if (!m_cameras.empty() || m_headerCameras) return;
  m_files.require(kPosition, ", or camera.json beside the files");
}

Image MultilayerSequence::readOne(int frame, const char* image) const {
  FrameData unwatched;  // warnings are those of reading the frame itself
  unwatched.number = frame;
  OpenFiles files;
  return m_files.read(files, unwatched, image);
}

DepthKind MultilayerSequence::depthKind() const { return m_files.kindOf(kDepth).depth; }

Image MultilayerSequence::viewDepth(int frame, const Image& positions) const {
  const bool known = m_files.has(kDepth) && (depthKind() == DepthKind::View || depthKind() == DepthKind::Ray);
  if (!known) return viewDepthFromPositions(positions, readOne(frame, kNormal));
  Image depth = readOne(frame, kDepth);
  if (depthKind() == DepthKind::View) return depth;
  auto view = viewDepthFromRays(positions, depth);
  return view ? std::move(*view) : Image(depth.width, depth.height, 1, kNoSurfaceDepth);
}

std::optional<Matrix4> MultilayerSequence::headerCamera(int frame, const Image& positions) const {
  const std::vector<Matrix4> cameras = headerCameras(readExrHeader(m_files.fileOf(frame)));
  if (!m_form) m_form = fittingCamera(cameras, positions);
  if (!m_form || *m_form >= cameras.size()) return std::nullopt;
  return cameras[*m_form];
}

const FoundCamera& MultilayerSequence::foundCamera(int frame) const {
  const auto known = m_found.find(frame);
  if (known != m_found.end()) return known->second;
  FoundCamera found;
  const Image positions = m_files.has(kPosition) ? readOne(frame, kPosition) : Image();
  if (m_headerCameras) found.worldToClip = headerCamera(frame, positions);
  if (!found.worldToClip && positions.empty())
    throwFileError("read frame", m_files.fileOf(frame),
                   "a camera in the header that puts positions at their pixels",
                   "one that does not; camera.json beside the file would tell");
  if (!found.worldToClip) found = findCamera(positions, viewDepth(frame, positions));
  return m_found[frame] = std::move(found);
}

std::optional<int> MultilayerSequence::lastFrameWithCamera(int frame) const {
  const std::vector<int>& frames = m_files.frames();
  for (auto last = std::upper_bound(frames.begin(), frames.end(), frame); last != frames.begin();)
    if (foundCamera(*--last).worldToClip) return *last;
  return std::nullopt;
}

Matrix4 MultilayerSequence::worldToClipOf(int frame) const {
  if (const auto found = lastFrameWithCamera(frame)) return *foundCamera(*found).worldToClip;
  const Image positions = readOne(frame, kPosition);
  return standInCamera(positions, readOne(frame, kNormal), viewDepth(frame, positions));
}

void MultilayerSequence::setCamera(FrameData& data) const {
  const int frame = data.number;
  if (!m_cameras.empty()) {
    m_cameras.setCamera(data, [&] { return m_files.has(kPosition) ? readOne(frame, kPosition) : Image(); });
    return;
  }
  const bool follows = std::binary_search(m_files.frames().begin(), m_files.frames().end(), frame - 1);
  data.camera.worldToClip = worldToClipOf(frame);
  data.camera.worldToClipPrev = follows ? worldToClipOf(frame - 1) : data.camera.worldToClip;
  if (foundCamera(frame).worldToClip) return;
  const auto last = lastFrameWithCamera(frame);
  data.warnings.push_back({FrameWarning::Kind::Camera, m_files.fileOf(frame),
                           "camera.json, or a perspective camera that follows from positions",
                           foundCamera(frame).failure,
                           (last ? fmt::format("goes on with that of frame {}", *last)
                                 : std::string("goes on with one made up, mostly without history")) +
                               ", and so do others like it; camera.json beside the files would tell"});
}

Image MultilayerSequence::readPositions(OpenFiles& files, FrameData& data) const {
  if (m_files.has(kPosition)) return m_files.read(files, data, kPosition);
  const Image depth = viewDepthOf(m_files.read(files, data, kDepth), depthKind(),
                                  {data.camera.worldToClip, data.camera.jitterPx,
                                   m_cameras.empty() ? std::nullopt : m_cameras.rangeOf(data.number)},
                                  m_files.fileOf(data.number, kDepth));
  auto position = positionsFromDepth(data.camera.worldToClip, depth);
  if (!position)
    throwFileError("read frame", m_files.fileOf(data.number, kDepth), "channels of position",
                   "a camera from which positions cannot be found by depth");
  return std::move(*position);
}

void MultilayerSequence::readMotion(FrameData& data) const {
  const PixelWindow& picture = m_files.windows().display;
  toContract(data.motion, m_files.kindOf(kMotion).motion, picture.width, picture.height);
  if (m_files.map().renderer == kCycles) withoutBackground(data.motion, data.normalWorld);
}

FrameData MultilayerSequence::read(int frame) const {
  requireFrame(m_name, m_files.frames(), frame);
  FrameData data;
  data.number = frame;
  markGap(data, m_files.frames(), m_files.fileOf(frame - 1));
  OpenFiles files;
  data.origin = m_files.origin(files, frame);
  setCamera(data);
  data.demodulated = m_signals == 2;
  for (const ImageSource& source : imageSources(m_signals)) {
    if (source.image == &FrameData::positionWorld) {
      data.positionWorld = readPositions(files, data);
    } else if (m_files.has(source.files.role)) {
      data.*source.image = m_files.read(files, data, source.files.role);
    }
  }
  if (m_files.has(kAlpha)) data.alpha = m_files.read(files, data, kAlpha);
  if (!data.motion.empty()) readMotion(data);
  if (m_signals == 2)
    keepRemainder(data, m_files.has(kTransmission) ? m_files.read(files, data, kTransmission) : Image());
  return data;
}

std::string MultilayerSequence::fileOf(int frame, const ImageFiles& files) const {
  return m_files.fileOf(frame, files.role);
}

void MultilayerSequence::requireReadable(const std::vector<int>& frames) const {
  for (const int frame : frames) m_files.requireReadable(frame);
}

bool MultilayerSequence::hasReference(int frame, ReferenceKind kind) const {
  return !m_files.referenceFile(frame, kind, 'a').empty();
}

Reference MultilayerSequence::reference(int frame, ReferenceKind kind) const {
  requireReference(*this, frame, kind);
  Reference reference{m_files.readReference(m_files.referenceFile(frame, kind, 'a')), {}, kind};
  if (const std::string other = m_files.referenceFile(frame, kind, 'b'); !other.empty())
    reference.b = m_files.readReference(other);
  return reference;
}

}  // namespace quell::io
