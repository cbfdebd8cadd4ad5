#include "host/io/cycles_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host/io/exr_image.hpp"
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
  m_width = first.width;
  m_height = first.height;
  m_cameras = DeclaredCameras(joinPath(m_directory, kCyclesCameraFile), first.windows, m_frames);
}

const FrameFiles& CyclesSequence::filesOf(const std::string& stem) const {
  return m_files.withPrefix(stem + "_");
}

Image CyclesSequence::readImage(const std::string& stem, const char* channels, int frame) const {
  return readLettersOfSize(filesOf(stem).path(frame), channels, m_width, m_height);
}

FrameData CyclesSequence::read(int frame) const {
  requireFrame(m_directory, m_frames, frame);
  FrameData data;
  data.number = frame;
  markGap(data, m_frames, filesOf(kColor.stem).path(frame - 1));
  data.demodulated = m_demodulated;
  for (const ImageSource& source : m_sources)
    data.*source.image = readImage(source.files.stem, source.files.channels, frame);
  m_cameras.setCamera(data, [&] { return data.positionWorld; });
  if (m_hasAlpha) data.alpha = readImage(kColor.stem, "A", frame);
  return data;
}

std::string CyclesSequence::fileOf(int frame, const ImageFiles& files) const {
  return filesOf(files.stem).path(frame);
}

bool CyclesSequence::jittered() const { return m_cameras.jittered(m_frames); }

bool CyclesSequence::hasReference(int frame, ReferenceKind kind) const {
  return filesOf(referenceStem(kind, 'a', kColor.stem)).has(frame);
}

Reference CyclesSequence::reference(int frame, ReferenceKind kind) const {
  requireReference(*this, frame, kind);
  const auto stem = [kind](char half) { return referenceStem(kind, half, kColor.stem); };
  Reference reference{readImage(stem('a'), kColor.channels, frame), {}, kind};
  if (filesOf(stem('b')).has(frame)) reference.b = readImage(stem('b'), kColor.channels, frame);
  return reference;
}

}  // namespace quell::io
