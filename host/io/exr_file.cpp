#include "host/io/exr_file.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "host/io/exr_open.hpp"

namespace quell::io {
namespace {

using ChannelNames = std::vector<std::string>;

/// Channel sets by preference: colour, vectors, a scalar, 2-D motion.
const std::vector<ChannelNames>& knownChannelSets() {
  static const std::vector<ChannelNames> sets = {{"R", "G", "B"}, {"X", "Y", "Z"}, {"Y"}, {"R", "G"}};
  return sets;
}

bool containsAll(const ChannelNames& present, const ChannelNames& wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](const std::string& name) {
    return std::find(present.begin(), present.end(), name) != present.end();
  });
}

[[noreturn]] void throwMissingChannels(const std::string& path, const std::string& wanted,
                                       const ChannelNames& present) {
  throwFileError(
      kReadExr, path, "channels " + wanted,
      fmt::format("only {}", present.empty() ? "none" : fmt::format("{}", fmt::join(present, " "))));
}

/// Where a channel is: the part, and its name there.
struct StoredChannel {
  std::size_t part;
  std::string name;
};
using StoredChannels = std::vector<StoredChannel>;

std::optional<StoredChannel> findChannel(const ExrHeader& header, const std::string& name) {
  for (std::size_t part = 0; part < header.parts.size(); ++part)
    for (const std::string& stored : header.parts[part].channels)
      if (nameInFile(header, header.parts[part], stored) == name) return StoredChannel{part, stored};
  return std::nullopt;
}

StoredChannels findNamed(const std::string& path, const ExrHeader& header, const ChannelNames& names) {
  StoredChannels found;
  for (const std::string& name : names) {
    const auto channel = findChannel(header, name);
    if (!channel) throwMissingChannels(path, fmt::format("{}", fmt::join(names, " ")), header.channels);
    found.push_back(*channel);
  }
  return found;
}

/// Of the first part that has one of the known sets, of at least so many channels, under their bare names.
StoredChannels findKnownSet(const std::string& path, const ExrHeader& header, std::size_t leastChannels,
                            const std::string& wanted) {
  for (const ChannelNames& names : knownChannelSets()) {
    if (names.size() < leastChannels) continue;
    for (std::size_t part = 0; part < header.parts.size(); ++part) {
      if (!containsAll(header.parts[part].channels, names)) continue;
      StoredChannels found;
      for (const std::string& name : names) found.push_back({part, name});
      return found;
    }
  }
  throwMissingChannels(path, wanted, header.channels);
}

StoredChannels find(const std::string& path, const ExrHeader& header, const ChannelNames& names) {
  return names.empty() ? findKnownSet(path, header, 3, "R G B or X Y Z") : findNamed(path, header, names);
}

PictureWindows windowsOfPart(const ExrHeader& header, std::size_t part) {
  return {header.parts[part].data, header.windows.display};
}

/// Lines that are read at a time. Memory of images is touched as lines come, not before: headers may lie.
constexpr int kLinesAtATime = 256;

/// Names as stored in the part.
Image readChannels(Imf::MultiPartInputFile& file, std::size_t partNumber, const PixelWindow& data,
                   const ChannelNames& names) {
  Image image;
  image.width = data.width;
  image.height = data.height;
  image.channels = int(names.size());
  const std::size_t xStride = names.size() * sizeof(float);
  const std::size_t samplesOfLine = names.size() * std::size_t(data.width);
  image.pixels.reserve(samplesOfLine * std::size_t(data.height));  // its address stays
  Imf::InputPart part(file, int(partNumber));
  const Imath::Box2i window = part.header().dataWindow();
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < names.size(); ++c)
    buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + c, window, xStride,
                                             samplesOfLine * sizeof(float)));
  part.setFrameBuffer(buffer);
  for (int line = 0; line < data.height; line += kLinesAtATime) {
    const int end = std::min(line + kLinesAtATime, data.height);
    image.pixels.resize(samplesOfLine * std::size_t(end));
    part.readPixels(window.min.y + line, window.min.y + end - 1);
  }
  return image;
}

/// Channels of one part in one reading; of several, one after another.
Image readFound(Imf::MultiPartInputFile& file, const ExrHeader& header, const StoredChannels& found) {
  const std::size_t first = found.front().part;
  const PixelWindow data = header.parts[first].data;
  if (std::all_of(found.begin(), found.end(), [&](const auto& channel) { return channel.part == first; })) {
    ChannelNames stored;
    for (const StoredChannel& channel : found) stored.push_back(channel.name);
    return readChannels(file, first, data, stored);
  }
  Image image(data.width, data.height, int(found.size()));
  for (std::size_t c = 0; c < found.size(); ++c) {
    const PixelWindow& from = header.parts[found[c].part].data;
    const Image plane = placed(readChannels(file, found[c].part, from, {found[c].name}), from, data);
    for (std::size_t i = 0; i < plane.pixels.size(); ++i)
      image.pixels[i * found.size() + c] = plane.pixels[i];
  }
  return image;
}

}  // namespace

struct ExrFile::Open {
  explicit Open(const std::string& path) : file(openExr(path)), header(describe(file)) {}

  PlacedImage read(const StoredChannels& found) {
    return {readFound(file, header, found), windowsOfPart(header, found.front().part)};
  }

  Imf::MultiPartInputFile file;
  ExrHeader header;
};

ExrFile::ExrFile(std::string path)
    : m_path(std::move(path)),
      m_open(withExrErrors(m_path, [&] { return std::make_unique<Open>(m_path); })) {}

ExrFile::ExrFile(ExrFile&&) noexcept = default;
ExrFile::~ExrFile() = default;

const ExrHeader& ExrFile::header() const { return m_open->header; }

PlacedImage ExrFile::read(const ChannelNames& channels) const {
  return withExrErrors(m_path, [&] { return m_open->read(find(m_path, header(), channels)); });
}

PlacedImage ExrFile::readKnown() const {
  return withExrErrors(
      m_path, [&] { return m_open->read(findKnownSet(m_path, header(), 1, "R G B, X Y Z, Y or R G")); });
}

PictureWindows ExrFile::windowsOf(const ChannelNames& channels) const {
  return windowsOfPart(header(), find(m_path, header(), channels).front().part);
}

}  // namespace quell::io
