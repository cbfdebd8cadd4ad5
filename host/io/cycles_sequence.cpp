#include "host/io/cycles_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host/io/exr_image.hpp"
#include "host/io/light_remainder.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {
namespace {

constexpr ImageFiles kColor = factsOf(&FrameData::radiance).files;

}  // namespace

CyclesSequence::CyclesSequence(std::string directory, int signals, MissingFrames missing, FrameFiles colors)
    : m_directory(std::move(directory)), m_files(m_directory), m_demodulated(signals == 2) {
  std::vector<FrameFiles> required = {colors.empty() ? filesOf(kColor.stem) : std::move(colors)};
  for (const ImageSource& source : imageSources(signals))
    if (source.required) required.push_back(filesOf(source.files.stem));
  m_frames = framesOf(required, missing);
  for (const ImageSource& source : imageSources(signals))
    if (source.files.stem[0] != '\0' && (source.required || hasAll(filesOf(source.files.stem), m_frames)))
      m_sources.push_back(source);

  const ExrHeader first = readExrHeader(required.front().path(m_frames.front()));
  m_hasAlpha = std::count(first.channels.begin(), first.channels.end(), "A") > 0;
  m_windows = first.windows;
  m_cameras = DeclaredCameras(joinPath(m_directory, kCyclesCameraFile), m_windows, m_frames);
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
  data.demodulated = m_demodulated;
  for (const ImageSource& source : m_sources)
    data.*source.image = readImage(source.files.stem, source.files.channels, frame, data.warnings);
  m_cameras.setCamera(data, [&] { return data.positionWorld; });
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

bool CyclesSequence::jittered() const { return m_cameras.jittered(m_frames); }

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
