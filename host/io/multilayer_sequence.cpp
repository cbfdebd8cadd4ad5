#include "host/io/multilayer_sequence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <sstream>

#include "host/io/cycles_sequence.hpp"
#include "host/io/exr_camera.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/file_error.hpp"
#include "host/io/image_sources.hpp"
#include "host/io/multilayer_camera.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {
namespace {

namespace fs = std::filesystem;

constexpr char kStage[] = "open sequence";
constexpr char kCombined[] = ".Combined.R";
/// Blender adds what its compositor makes as a layer of this name.
constexpr char kCompositorLayer[] = "Composite";

constexpr ImageFiles kPosition = factsOf(&FrameData::positionWorld).files;
constexpr ImageFiles kNormal = factsOf(&FrameData::normalWorld).files;
constexpr ImageFiles kColor = factsOf(&FrameData::radiance).files;
constexpr ImageFiles kDepth = factsOf(&FrameData::viewDepth).files;

/// An image is the sum of these.
std::vector<std::string> passesOf(const ImageFiles& files) {
  std::vector<std::string> passes;
  std::istringstream list(files.passes);
  for (std::string pass; std::getline(list, pass, '+');) passes.push_back(pass);
  return passes;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The view layers: what stands before .Combined.R.
std::vector<std::string> layersOf(const std::vector<std::string>& channels) {
  std::vector<std::string> layers;
  for (const std::string& channel : channels)
    if (endsWith(channel, kCombined))
      layers.push_back(channel.substr(0, channel.size() - std::string(kCombined).size()));
  if (layers.size() > 1)
    layers.erase(std::remove(layers.begin(), layers.end(), kCompositorLayer), layers.end());
  return layers;
}

}  // namespace

bool isMultilayerFile(const std::string& path) {
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) return false;
  try {
    return !layersOf(readExrHeader(path).channels).empty();
  } catch (const Error&) {
    return false;
  }
}

FrameFiles findMultilayerFiles(const std::string& directory) {
  std::vector<FrameFiles> found;
  for (FrameFiles& files : FrameDirectory(directory).all()) {
    const std::vector<int> frames = files.frames();
    if (std::any_of(frames.begin(), frames.end(),
                    [&](int frame) { return isMultilayerFile(files.path(frame)); }))
      found.push_back(std::move(files));
  }
  return found.empty() ? FrameFiles() : requireOneSequence(directory, found);
}

MultilayerSequence::MultilayerSequence(std::string name, FrameFiles files, int signals, MissingFrames missing)
    : m_name(std::move(name)),
      m_files(std::move(files)),
      m_frames(framesOf({m_files}, missing)),
      m_signals(signals) {
  const std::string path = m_files.path(m_frames.front());
  const ExrHeader header = readExrHeader(path);
  m_width = header.width;
  m_height = header.height;
  m_channels = header.channels;
  const std::vector<std::string> layers = layersOf(m_channels);
  if (layers.size() != 1)
    throwFileError(kStage, path, "one view layer with the pass Combined",
                   layers.empty() ? "none" : fmt::format("{}", fmt::join(layers, ", ")));
  m_layer = layers.front();
  m_headerCameras = !headerCameras(header).empty();
  openCameras(m_files.directory());
  requirePasses();
}

void MultilayerSequence::openCameras(const std::string& directory) {
  if (!hasFile(directory.empty() ? "." : directory, kCyclesCameraFile)) return;
  const PixelWindow whole{0, 0, m_width, m_height};
  m_cameras = DeclaredCameras(joinPath(directory, kCyclesCameraFile), {whole, whole}, m_frames);
}

void MultilayerSequence::requirePasses() const {
  // The light of two signals is divided by these.
  const auto isFactor = [](const ImageSource& source) {
    return source.image == &FrameData::albedo || source.image == &FrameData::glossColor;
  };
  for (const ImageSource& source : imageSources(m_signals))
    if (source.image != &FrameData::positionWorld &&
        (source.required || (m_signals == 2 && isFactor(source))))
      for (const std::string& pass : passesOf(source.files))
        if (!hasPass(pass, source.files.passChannels))
          throwFileError(kStage, m_name, fmt::format("the pass {}.{}", m_layer, pass), "a file without it");
  const bool position = hasImage(kPosition), depth = hasImage(kDepth);
  if (m_cameras.empty() && !m_headerCameras && !(position && depth))
    throwFileError(
        kStage, m_name,
        fmt::format("the pass {}.{}, or camera.json beside it", m_layer, position ? "Depth" : "Position"),
        "neither");
  if (!position && !depth)
    throwFileError(kStage, m_name, fmt::format("the pass {0}.Position or {0}.Depth", m_layer), "neither");
}

std::vector<std::string> MultilayerSequence::channelsOf(const std::string& pass,
                                                        const std::string& letters) const {
  std::vector<std::string> names;
  for (const char letter : letters) names.push_back(m_layer + "." + pass + "." + letter);
  return names;
}

bool MultilayerSequence::hasPass(const std::string& pass, const std::string& letters) const {
  const std::vector<std::string> names = channelsOf(pass, letters);
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::find(m_channels.begin(), m_channels.end(), name) != m_channels.end();
  });
}

bool MultilayerSequence::hasImage(const ImageFiles& files) const {
  const std::vector<std::string> passes = passesOf(files);
  return std::any_of(passes.begin(), passes.end(),
                     [&](const std::string& pass) { return hasPass(pass, files.passChannels); });
}

Image MultilayerSequence::readImage(int frame, const ImageFiles& files) const {
  Image sum;
  for (const std::string& pass : passesOf(files)) {
    if (!hasPass(pass, files.passChannels)) continue;
    Image image =
        readChannelsOfSize(m_files.path(frame), channelsOf(pass, files.passChannels), m_width, m_height);
    if (sum.empty()) {
      sum = std::move(image);
    } else {
      for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += image.pixels[i];
    }
  }
  return sum;
}

std::optional<Matrix4> MultilayerSequence::headerCamera(int frame, const Image& positions) const {
  const std::vector<Matrix4> cameras = headerCameras(readExrHeader(m_files.path(frame)));
  if (!m_form) m_form = fittingCamera(cameras, positions);
  if (!m_form || *m_form >= cameras.size()) return std::nullopt;
  return cameras[*m_form];
}

const FoundCamera& MultilayerSequence::foundCamera(int frame) const {
  const auto known = m_found.find(frame);
  if (known != m_found.end()) return known->second;
  FoundCamera found;
  const Image positions = hasImage(kPosition) ? readImage(frame, kPosition) : Image();
  if (m_headerCameras) found.worldToClip = headerCamera(frame, positions);
  if (!found.worldToClip && (positions.empty() || !hasImage(kDepth)))
    throwFileError("read frame", m_files.path(frame),
                   "a camera in the header that puts positions at their pixels",
                   "one that does not; camera.json beside the file would tell");
  if (!found.worldToClip) found = findCamera(positions, readImage(frame, kDepth));
  return m_found[frame] = std::move(found);
}

std::optional<int> MultilayerSequence::lastFrameWithCamera(int frame) const {
  for (auto last = std::upper_bound(m_frames.begin(), m_frames.end(), frame); last != m_frames.begin();)
    if (foundCamera(*--last).worldToClip) return *last;
  return std::nullopt;
}

Matrix4 MultilayerSequence::worldToClipOf(int frame) const {
  if (const auto found = lastFrameWithCamera(frame)) return *foundCamera(*found).worldToClip;
  return standInCamera(readImage(frame, kPosition), readImage(frame, kNormal), readImage(frame, kDepth));
}

void MultilayerSequence::setCamera(FrameData& data) const {
  const int frame = data.number;
  if (!m_cameras.empty()) {
    m_cameras.setCamera(data, [&] { return hasImage(kPosition) ? readImage(frame, kPosition) : Image(); });
    return;
  }
  data.camera.worldToClip = worldToClipOf(frame);
  data.camera.worldToClipPrev = m_files.has(frame - 1) ? worldToClipOf(frame - 1) : data.camera.worldToClip;
  if (foundCamera(frame).worldToClip) return;
  const auto last = lastFrameWithCamera(frame);
  data.warnings.push_back({FrameWarning::Kind::Camera, m_files.path(frame),
                           "camera.json, or a perspective camera that follows from Position and Depth",
                           foundCamera(frame).failure,
                           (last ? fmt::format("goes on with that of frame {}", *last)
                                 : std::string("goes on with one made up, mostly without history")) +
                               ", and so do others like it; camera.json beside the files would tell"});
}

Image MultilayerSequence::readPositions(int frame, const Matrix4& worldToClip) const {
  if (hasImage(kPosition)) return readImage(frame, kPosition);
  auto position = positionsFromDepth(worldToClip, readImage(frame, kDepth));
  if (!position)
    throwFileError("read frame", m_files.path(frame), fmt::format("the pass {}.Position", m_layer),
                   "a camera from which positions cannot be found by Depth");
  return std::move(*position);
}

FrameData MultilayerSequence::read(int frame) const {
  requireFrame(m_name, m_frames, frame);
  FrameData data;
  data.number = frame;
  markGap(data, m_frames, m_files.path(frame - 1));
  setCamera(data);
  data.demodulated = m_signals == 2;
  for (const ImageSource& source : imageSources(m_signals))
    data.*source.image = source.image == &FrameData::positionWorld
                             ? readPositions(frame, data.camera.worldToClip)
                             : readImage(frame, source.files);
  if (hasPass(kColor.passes, "A"))
    data.alpha = readChannelsOfSize(m_files.path(frame), channelsOf(kColor.passes, "A"), m_width, m_height);
  for (std::size_t pixel = 0; !data.motion.empty() && pixel < data.normalWorld.pixels.size() / 3; ++pixel) {
    float* motion = &data.motion.pixels[2 * pixel];
    const float* normal = &data.normalWorld.pixels[3 * pixel];
    // Blender's y points up, and its background has no motion, whatever the camera does: better no history there.
    const bool background = normal[0] == 0.0f && normal[1] == 0.0f && normal[2] == 0.0f;
    motion[1] = background ? std::numeric_limits<float>::quiet_NaN() : -motion[1];
  }
  return data;
}

bool MultilayerSequence::hasReference(int /*frame*/, ReferenceKind /*kind*/) const { return false; }

Reference MultilayerSequence::reference(int frame, ReferenceKind kind) const {
  requireReference(*this, frame, kind);
  return {};
}

}  // namespace quell::io
