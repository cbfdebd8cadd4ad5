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

}  // namespace

std::vector<PassFiles> passFilesOf(const FrameDirectory& directory) {
  std::vector<PassFiles> passes;
  for (FrameFiles& files : directory.all()) {
    std::string name = std::filesystem::path(files.prefix()).filename().string();
    const std::size_t last = name.find_last_not_of(kSeparators);
    name.resize(last == std::string::npos ? 0 : last + 1);
    passes.push_back({name, std::move(files)});
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
  std::vector<FrameFiles> required = {passOf("color").files};
  for (const std::size_t pass : used) required.push_back(m_passes[pass].files);
  m_frames = framesOf(required, missing);
  m_windows = origin(m_frames.front()).windows;
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

DepthKind ChannelFiles::depthKind() const {
  const auto depth = m_map.images.find("depth");
  return depth == m_map.images.end() ? DepthKind::View : depth->second.depth;
}

const PassFiles& ChannelFiles::passOf(const std::string& image) const {
  const auto found = m_map.images.find(image);
  const auto& channels = (found != m_map.images.end() ? found : m_map.images.find("color"))->second;
  return m_passes[m_places.at(channels.terms.front().front()).pass];
}

std::string ChannelFiles::fileOf(int frame, const std::string& image) const {
  return passOf(image).files.path(frame);
}

const std::string& ChannelFiles::directory() const { return passOf("color").files.directory(); }

Image ChannelFiles::readTerm(FrameData& data, const std::vector<std::string>& channels) const {
  const std::size_t first = m_places.at(channels.front()).pass;
  std::vector<std::string> names;
  for (const std::string& channel : channels)
    if (m_places.at(channel).pass == first) names.push_back(m_places.at(channel).name);
  if (names.size() == channels.size())
    return readWithin(m_passes[first].files.path(data.number), names, m_windows, data.warnings);
  Image image(m_windows.data.width, m_windows.data.height, int(channels.size()));
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Place& place = m_places.at(channels[c]);
    const Image plane =
        readWithin(m_passes[place.pass].files.path(data.number), {place.name}, m_windows, data.warnings);
    for (std::size_t i = 0; i < plane.pixels.size(); ++i)
      image.pixels[i * channels.size() + c] = plane.pixels[i];
  }
  return image;
}

Image ChannelFiles::read(FrameData& data, const std::string& image) const {
  Image sum;
  for (const std::vector<std::string>& term : m_map.images.at(image).terms) {
    Image part = readTerm(data, term);
    if (sum.empty()) {
      sum = std::move(part);
    } else {
      for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += part.pixels[i];
    }
  }
  return sum;
}

ExrOrigin ChannelFiles::origin(int frame) const {
  const std::string path = fileOf(frame);
  const ExrHeader header = readExrHeader(path);
  const std::string channel = m_places.at(m_map.images.at("color").terms.front().front()).name;
  ExrOrigin origin{header.windows, header.attributes};
  // Parts may have windows of their own.
  for (const ExrPart& part : header.parts)
    for (const std::string& stored : part.channels)
      if (nameInFile(header, part, stored) == channel) origin.windows.data = part.data;
  // None yet while the first frame is looked at.
  if (m_windows.data.width > 0) requireWindows(path, origin.windows, m_windows);
  return origin;
}

}  // namespace quell::io
