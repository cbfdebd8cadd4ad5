#include "host/io/exr_image.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "host/io/exr_open.hpp"

namespace quell::io {
namespace {

constexpr char kReadStage[] = "read EXR";
using ChannelNames = std::vector<std::string>;

/// Channel sets by preference: colour, vectors, a scalar, 2-D motion.
const std::vector<ChannelNames>& knownChannelSets() {
  static const std::vector<ChannelNames> sets = {{"R", "G", "B"}, {"X", "Y", "Z"}, {"Y"}, {"R", "G"}};
  return sets;
}

bool contains(const ChannelNames& present, const std::string& name) {
  return std::find(present.begin(), present.end(), name) != present.end();
}

bool containsAll(const ChannelNames& present, const ChannelNames& wanted) {
  return std::all_of(wanted.begin(), wanted.end(),
                     [&](const std::string& name) { return contains(present, name); });
}

[[noreturn]] void throwMissingChannels(const std::string& path, const std::string& wanted,
                                       const ChannelNames& present) {
  throwFileError(
      kReadStage, path, "channels " + wanted,
      fmt::format("only {}", present.empty() ? "none" : fmt::format("{}", fmt::join(present, " "))));
}

/// Lines that are read at a time. Memory of images is touched as lines come, not before: headers may lie.
constexpr int kLinesAtATime = 256;

/// Names as stored in the part.
Image readChannels(Imf::MultiPartInputFile& file, int partNumber, const PixelWindow& data,
                   const ChannelNames& names) {
  Image image;
  image.width = data.width;
  image.height = data.height;
  image.channels = int(names.size());
  const std::size_t xStride = names.size() * sizeof(float);
  const std::size_t samplesOfLine = names.size() * std::size_t(data.width);
  image.pixels.reserve(samplesOfLine * std::size_t(data.height));  // its address stays
  Imf::InputPart part(file, partNumber);
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

/// Where a channel is: the part, and its name there.
struct StoredChannel {
  int part;
  std::string name;
};

std::optional<StoredChannel> findChannel(const ExrHeader& header, const std::string& name) {
  for (std::size_t part = 0; part < header.parts.size(); ++part)
    for (const std::string& stored : header.parts[part].channels)
      if (nameInFile(header, header.parts[part], stored) == name) return StoredChannel{int(part), stored};
  return std::nullopt;
}

/// Channels of one part in one reading; of several, one after another.
PlacedImage readNamed(Imf::MultiPartInputFile& file, const ExrHeader& header, const ChannelNames& names) {
  std::vector<StoredChannel> found;
  for (const std::string& name : names) found.push_back(*findChannel(header, name));
  const int first = found.front().part;
  const PixelWindow data = header.parts[std::size_t(first)].data;
  PlacedImage result{{}, {data, header.windows.display}};
  if (std::all_of(found.begin(), found.end(), [&](const auto& channel) { return channel.part == first; })) {
    ChannelNames stored;
    for (const StoredChannel& channel : found) stored.push_back(channel.name);
    result.image = readChannels(file, first, data, stored);
    return result;
  }
  result.image = Image(data.width, data.height, int(names.size()));
  for (std::size_t c = 0; c < found.size(); ++c) {
    const PixelWindow& from = header.parts[std::size_t(found[c].part)].data;
    const Image plane = placed(readChannels(file, found[c].part, from, {found[c].name}), from, data);
    for (std::size_t i = 0; i < plane.pixels.size(); ++i)
      result.image.pixels[i * names.size() + c] = plane.pixels[i];
  }
  return result;
}

/// Of the first part that has one of the known sets, of at least so many channels, under their bare names.
PlacedImage readKnownSet(Imf::MultiPartInputFile& file, const ExrHeader& header, std::size_t leastChannels,
                         const std::string& path, const std::string& wanted) {
  for (const ChannelNames& names : knownChannelSets()) {
    if (names.size() < leastChannels) continue;
    for (std::size_t part = 0; part < header.parts.size(); ++part) {
      const PixelWindow& data = header.parts[part].data;
      if (containsAll(header.parts[part].channels, names))
        return {readChannels(file, int(part), data, names), {data, header.windows.display}};
    }
  }
  throwMissingChannels(path, wanted, header.channels);
}

}  // namespace

Image readExr(const std::string& path) {
  return withExrFile(path, [&](Imf::MultiPartInputFile& file, const ExrHeader& header) {
    return readKnownSet(file, header, 1, path, "R G B, X Y Z, Y or R G").image;
  });
}

PlacedImage readPlacedExr(const std::string& path, const std::vector<std::string>& channels) {
  return withExrFile(path, [&](Imf::MultiPartInputFile& file, const ExrHeader& header) {
    if (channels.empty()) return readKnownSet(file, header, 3, path, "R G B or X Y Z");
    if (!containsAll(header.channels, channels))
      throwMissingChannels(path, fmt::format("{}", fmt::join(channels, " ")), header.channels);
    return readNamed(file, header, channels);
  });
}

Image readExr(const std::string& path, const std::vector<std::string>& channels) {
  if (channels.empty()) throwMissingChannels(path, "of at least one name", readExrHeader(path).channels);
  return readPlacedExr(path, channels).image;
}

Image readExrRgb(const std::string& path) { return readPlacedExr(path).image; }

void requireSize(const Image& image, int width, int height, const std::string& path) {
  if (image.width == width && image.height == height) return;
  throw Error(ErrorCode::InvalidArgument, {"read image", path, fmt::format("{}x{} pixels", width, height),
                                           fmt::format("{}x{}", image.width, image.height)});
}

}  // namespace quell::io
