#include "host/io/cycles_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

FrameData CyclesSequence::read(int frame) const {
  requireFrame(m_directory, m_frames, frame);
  FrameData data;
  data.number = frame;
  markGap(data, m_frames, filesOf(kColor.stem).path(frame - 1));
  OpenFiles files;
  const ExrFile& color = files.at(filesOf(kColor.stem).path(frame));
  data.origin = originOf(color, m_windows);
  data.demodulated = m_demodulated;
  for (const ImageSource& source : m_sources)
    data.*source.image = readWithin(files.at(filesOf(source.files.stem).path(frame)),
                                    channelsOfLetters(source.files.channels), m_windows, data.warnings);
  m_cameras.setCamera(data, [&] { return data.positionWorld; });
  if (m_hasAlpha) data.alpha = readWithin(color, {"A"}, m_windows, data.warnings);
  if (m_demodulated) keepRemainder(data, Image());
  return data;
}

void CyclesSequence::requireReadable(const std::vector<int>& frames) const {
  for (const int frame : frames) {
    OpenFiles files;
    originOf(files.whole(filesOf(kColor.stem).path(frame)), m_windows);
    for (const ImageSource& source : m_sources)
      requireWithin(files.whole(filesOf(source.files.stem).path(frame)),
                    channelsOfLetters(source.files.channels), m_windows);
    for (const ReferenceKind kind : {ReferenceKind::Centre, ReferenceKind::Antialiased})
      for (const char half : {'a', 'b'})
        if (const FrameFiles& halves = filesOf(referenceStem(kind, half, kColor.stem)); halves.has(frame))
          requireWithin(files.whole(halves.path(frame)), channelsOfLetters(kColor.channels), m_windows);
  }
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
  const auto read = [&](char half) {
    std::vector<FrameWarning> unheard;  // a reference is looked at for figures, not for its frame
    const ExrFile file(filesOf(referenceStem(kind, half, kColor.stem)).path(frame));
    return readWithin(file, channelsOfLetters(kColor.channels), m_windows, unheard);
  };
  Reference reference{read('a'), {}, kind};
  if (filesOf(referenceStem(kind, 'b', kColor.stem)).has(frame)) reference.b = read('b');
  return reference;
}

}  // namespace quell::io
