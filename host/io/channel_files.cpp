#include "host/io/channel_files.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "host/io/file_error.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {
namespace {

/// What may stand between a pass and the number of the frame.
constexpr char kSeparators[] = "._-";

std::string trimmed(const std::string& text, bool begin, bool end) {
  const std::size_t first = begin ? text.find_first_not_of(kSeparators) : 0;
  const std::size_t last = end ? text.find_last_not_of(kSeparators) : text.size() - 1;
  if (text.empty() || first == std::string::npos || last == std::string::npos) return {};
  return text.substr(first, last + 1 - first);
}

/// What a file is called beside its number: "shot_ALBEDO" of shot_ALBEDO_0001.exr and of shot_0001_ALBEDO.exr.
std::string passName(const FrameFiles& files) {
  const std::string before = trimmed(files.prefix(), false, true);
  const std::string after = files.suffix().substr(0, files.suffix().rfind('.'));
  return before + trimmed(after, before.empty(), true);
}

}  // namespace

std::vector<PassFiles> passFilesOf(std::vector<FrameFiles> sequences) {
  std::vector<PassFiles> passes;
  for (FrameFiles& files : sequences) {
    std::string name = passName(files);
    passes.push_back({std::move(name), std::move(files)});
  }
  return passes;
}

ChannelFiles::ChannelFiles(std::string name, std::vector<PassFiles> passes, const ChannelOptions& options,
                           MissingFrames missing)
    : m_name(std::move(name)), m_options(options), m_passes(std::move(passes)) {
  requireChannelOptions(options);
  std::vector<std::string> views;
  for (std::size_t i = 0; i < m_passes.size(); ++i) lookInto(m_passes[i], i, views);
  m_map = findChannels(m_name, m_channels, views, options);
  std::set<std::size_t> used;
  for (const auto& [image, channels] : m_map.images)
    for (const std::vector<std::string>& term : channels.terms)
      for (const std::string& channel : term) used.insert(m_places.at(channel).pass);
  std::vector<FrameFiles> required = {passOf(kColor).files};
  for (const std::size_t pass : used) required.push_back(m_passes[pass].files);
  m_frames = framesOf(required, missing);
  OpenFiles first;
  m_windows = origin(first, m_frames.front()).windows;
}

void ChannelFiles::lookInto(const PassFiles& pass, std::size_t index, std::vector<std::string>& views) {
  const ExrHeader header = readExrHeader(pass.files.path(pass.files.frames().front()));
  for (const std::string& channel : header.channels) {
    const std::string name = pass.name.empty() ? channel : pass.name + "." + channel;
    if (m_places.try_emplace(name, Place{index, channel}).second) m_channels.push_back(name);
  }
  for (const std::string& view : header.views)
    if (std::find(views.begin(), views.end(), view) == views.end()) views.push_back(view);
}

void ChannelFiles::require(const std::string& image, const std::string& otherwise) const {
  requireImage(m_name, image, m_map, m_channels, m_options, otherwise);
}

NumberKind ChannelFiles::kindOf(const std::string& image) const {
  const auto found = m_map.images.find(image);
  return found == m_map.images.end() ? NumberKind() : found->second.kind;
}

const PassFiles& ChannelFiles::passOf(const std::string& image) const {
  const auto found = m_map.images.find(image);
  const auto& channels = (found != m_map.images.end() ? found : m_map.images.find(kColor))->second;
  return m_passes[m_places.at(channels.terms.front().front()).pass];
}

std::string ChannelFiles::fileOf(int frame, const std::string& image) const {
  return passOf(image).files.path(frame);
}

const std::string& ChannelFiles::directory() const { return passOf(kColor).files.directory(); }

std::vector<ChannelFiles::PassChannels> ChannelFiles::byPass(const std::vector<std::string>& channels) const {
  std::vector<PassChannels> parts;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Place& place = m_places.at(channels[c]);
    const bool follows = !parts.empty() && parts.back().pass == place.pass;
    if (!follows) parts.push_back({place.pass, c, {}});
    parts.back().names.push_back(place.name);
  }
  return parts;
}

Image ChannelFiles::readTerm(OpenFiles& files, FrameData& data,
                             const std::vector<std::string>& channels) const {
  const std::vector<PassChannels> parts = byPass(channels);
  const auto read = [&](const PassChannels& part) {
    return readWithin(files.at(m_passes[part.pass].files.path(data.number)), part.names, m_windows,
                      data.warnings);
  };
  if (parts.size() == 1) return read(parts.front());
  Image image(m_windows.data.width, m_windows.data.height, int(channels.size()));
  for (const PassChannels& part : parts) {
    const Image planes = read(part);
    const std::size_t count = part.names.size();
    for (std::size_t i = 0; i < planes.pixels.size(); ++i)
      image.pixels[i / count * channels.size() + part.first + i % count] = planes.pixels[i];
  }
  return image;
}

Image ChannelFiles::read(OpenFiles& files, FrameData& data, const std::string& image) const {
  Image sum;
  for (const std::vector<std::string>& term : m_map.images.at(image).terms) {
    Image part = readTerm(files, data, term);
    if (sum.empty()) {
      sum = std::move(part);
    } else {
      for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += part.pixels[i];
    }
  }
  return sum;
}

void ChannelFiles::requireReadable(int frame) const {
  OpenFiles files;
  files.whole(fileOf(frame));
  origin(files, frame);
  for (const auto& [image, channels] : m_map.images)
    for (const std::vector<std::string>& term : channels.terms)
      for (const PassChannels& part : byPass(term))
        requireWithin(files.whole(m_passes[part.pass].files.path(frame)), part.names, m_windows);
  for (const ReferenceKind kind : {ReferenceKind::Centre, ReferenceKind::Antialiased}) {
    for (const char half : {'a', 'b'}) {
      const std::string path = referenceFile(frame, kind, half);
      if (path.empty()) continue;
      const ExrFile& file = files.whole(path);
      requireWithin(file, referenceChannels(file), m_windows);
    }
  }
}

ExrOrigin ChannelFiles::origin(OpenFiles& files, int frame) const {
  const ExrFile& file = files.at(fileOf(frame));
  const std::string channel = m_places.at(m_map.images.at(kColor).terms.front().front()).name;
  // Parts may have windows of their own.
  const ExrOrigin origin{file.windowsOf({channel}), file.header().attributes};
  // None yet while the first frame is looked at.
  if (m_windows.data.width > 0) requireWindows(file.path(), origin.windows, m_windows);
  return origin;
}

std::string ChannelFiles::referenceFile(int frame, ReferenceKind kind, char half) const {
  if (!std::binary_search(m_frames.begin(), m_frames.end(), frame)) return {};
  const FrameFiles& colors = passOf(kColor).files;
  const std::string name = std::filesystem::path(colors.path(frame)).filename().string();
  for (const std::string& stem : {name, kColor + ("_" + colors.numberText(frame)) + ".exr"})
    if (const std::string file = referenceStem(kind, half, stem); hasFile(colors.directory(), file))
      return joinPath(colors.directory(), file);
  return {};
}

std::vector<std::string> ChannelFiles::referenceChannels(const ExrFile& file) const {
  std::vector<std::string> names;
  for (const std::string& channel : m_map.images.at(kColor).terms.front())
    names.push_back(m_places.at(channel).name);
  const std::vector<std::string>& there = file.header().channels;
  const bool named = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::find(there.begin(), there.end(), name) != there.end();
  });
  return named ? names : std::vector<std::string>();
}

Image ChannelFiles::readReference(const std::string& path) const {
  const ExrFile file(path);
  std::vector<FrameWarning> unheard;  // a reference is looked at for figures, not for its frame
  return readWithin(file, referenceChannels(file), m_windows, unheard);
}

}  // namespace quell::io
