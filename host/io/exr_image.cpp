#include "host/io/exr_image.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "host/io/atomic_file.hpp"
#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

constexpr char kReadStage[] = "read EXR";
/// Images beyond this many pixels (16384 x 16384) are taken for damaged headers rather than allocated.
constexpr std::int64_t kMaxPixels = std::int64_t(1) << 28;
/// Largest finite IEEE 754 binary16 value.
constexpr float kHalfMax = 65504.0f;

using ChannelNames = std::vector<std::string>;

/// Channel sets by preference: colour, vectors, a scalar, 2-D motion.
const std::vector<ChannelNames>& knownChannelSets() {
  static const std::vector<ChannelNames> sets = {{"R", "G", "B"}, {"X", "Y", "Z"}, {"Y"}, {"R", "G"}};
  return sets;
}

ExrHeader describe(const Imf::Header& header) {
  const Imath::Box2i window = header.dataWindow();
  const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
  const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1 || width > kMaxPixels / height)
    throw std::length_error(fmt::format("a data window of {}x{} pixels", width, height));
  ExrHeader result{int(width), int(height), {}};
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    result.channels.emplace_back(channel.name());
  return result;
}

/// Opens the file, calls use(Imf::InputFile&) and turns whatever OpenEXR throws into FileError.
template <typename Use>
auto withExrFile(const std::string& path, Use use) {
  std::error_code failure;
  if (!std::filesystem::exists(path, failure))
    throwFileError(kReadStage, path, "an OpenEXR image", "no such file");
  try {
    Imf::InputFile file(path.c_str());
    return use(file);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throwFileError(kReadStage, path, "a complete OpenEXR image", error.what());
  }
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

Image readChannels(Imf::InputFile& file, const ExrHeader& header, const ChannelNames& names) {
  Image image(header.width, header.height, int(names.size()));
  const std::size_t xStride = names.size() * sizeof(float);
  const std::size_t yStride = xStride * std::size_t(header.width);
  const Imath::Box2i window = file.header().dataWindow();
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < names.size(); ++c)
    buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + c, window, xStride, yStride));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return image;
}

ChannelNames namesForWriting(int channels) {
  for (const ChannelNames& names : knownChannelSets())
    if (int(names.size()) == channels) return names;
  return {};
}

[[noreturn]] void refuseShape(const std::string& path, const std::string& expected, const Image& image) {
  throw Error(ErrorCode::InvalidArgument,
              {"write EXR", path, expected,
               fmt::format("{}x{} pixels of {} channels", image.width, image.height, image.channels)});
}

/// Half range with NaN kept: every comparison with NaN is false, so std::clamp returns it.
half toHalf(float value) { return half(std::clamp(value, -kHalfMax, kHalfMax)); }

/// The largest float below 2^32.
constexpr float kUintMax = 4294967040.0f;

std::uint32_t toUint(float value) {
  return value > 0.0f ? static_cast<std::uint32_t>(std::min(std::round(value), kUintMax)) : 0u;
}

/// Encodes samples of type T (half, float or std::uint32_t), interleaved like Image, as a complete file in
/// memory.
template <typename T>
std::string encode(const Image& shape, const ChannelNames& names, const T* samples, Imf::PixelType type) {
  Imf::Header header(shape.width, shape.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer buffer;
  const std::size_t xStride = names.size() * sizeof(T);
  for (std::size_t c = 0; c < names.size(); ++c) {
    header.channels().insert(names[c], Imf::Channel(type));
    buffer.insert(names[c], Imf::Slice::Make(type, samples + c, header.dataWindow(), xStride,
                                             xStride * std::size_t(shape.width)));
  }
  Imf::StdOSStream stream;
  {
    Imf::OutputFile file(stream, header);  // its destructor completes the line offset table
    file.setFrameBuffer(buffer);
    file.writePixels(shape.height);
  }
  return stream.str();
}

std::string encode(const Image& image, const ChannelNames& names, ExrType type) {
  if (type == ExrType::Float) return encode(image, names, image.pixels.data(), Imf::FLOAT);
  if (type == ExrType::Uint) {
    std::vector<std::uint32_t> ids(image.pixels.size());
    std::transform(image.pixels.begin(), image.pixels.end(), ids.begin(), toUint);
    return encode(image, names, ids.data(), Imf::UINT);
  }
  std::vector<half> samples(image.pixels.size());
  std::transform(image.pixels.begin(), image.pixels.end(), samples.begin(), toHalf);
  return encode(image, names, samples.data(), Imf::HALF);
}

}  // namespace

ExrHeader readExrHeader(const std::string& path) {
  return withExrFile(path, [](Imf::InputFile& file) { return describe(file.header()); });
}

Image readExr(const std::string& path) {
  return withExrFile(path, [&](Imf::InputFile& file) {
    const ExrHeader header = describe(file.header());
    for (const ChannelNames& names : knownChannelSets())
      if (containsAll(header.channels, names)) return readChannels(file, header, names);
    throwMissingChannels(path, "R G B, X Y Z, Y or R G", header.channels);
  });
}

Image readExr(const std::string& path, const std::vector<std::string>& channels) {
  return withExrFile(path, [&](Imf::InputFile& file) {
    const ExrHeader header = describe(file.header());
    if (channels.empty() || !containsAll(header.channels, channels))
      throwMissingChannels(path, fmt::format("{}", fmt::join(channels, " ")), header.channels);
    return readChannels(file, header, channels);
  });
}

Image readExrRgb(const std::string& path) {
  return withExrFile(path, [&](Imf::InputFile& file) {
    const ExrHeader header = describe(file.header());
    for (const ChannelNames& names : knownChannelSets())
      if (names.size() == 3 && containsAll(header.channels, names)) return readChannels(file, header, names);
    throwMissingChannels(path, "R G B or X Y Z", header.channels);
  });
}

void requireSize(const Image& image, int width, int height, const std::string& path) {
  if (image.width == width && image.height == height) return;
  throw Error(ErrorCode::InvalidArgument, {"read image", path, fmt::format("{}x{} pixels", width, height),
                                           fmt::format("{}x{}", image.width, image.height)});
}

void writeExr(const std::string& path, const Image& image, ExrType type) {
  if (namesForWriting(image.channels).empty()) refuseShape(path, "an image of 1, 2 or 3 channels", image);
  writeExr(path, image, namesForWriting(image.channels), type);
}

void writeExr(const std::string& path, const Image& image, const std::vector<std::string>& channels,
              ExrType type) {
  if (image.empty() || int(channels.size()) != image.channels)
    refuseShape(path, fmt::format("an image of {} channels", channels.size()), image);
  std::string bytes;
  try {
    bytes = encode(image, channels, type);
  } catch (const std::exception& error) {
    throwFileError("write EXR", path, "to encode the image", error.what());
  }
  writeBinaryFile(path, bytes.data(), bytes.size());
}

}  // namespace quell::io
