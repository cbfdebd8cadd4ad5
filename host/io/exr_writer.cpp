#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <iterator>
#include <string_view>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "host/io/exr_samples.hpp"
#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

using ChannelNames = std::vector<std::string>;

ChannelNames namesForWriting(int channels) {
  if (channels == 1) return {"Y"};
  if (channels == 2) return {"R", "G"};
  return channels == 3 ? ChannelNames{"R", "G", "B"} : ChannelNames{};
}

[[noreturn]] void refuseShape(const std::string& path, const std::string& expected, const Image& image) {
  throw Error(ErrorCode::InvalidArgument,
              {"write EXR", path, expected,
               fmt::format("{}x{} pixels of {} channels", image.width, image.height, image.channels)});
}

/// Attributes that speak of how or what pixels are stored in a file, or show them.
bool staysBehind(const std::string& name) {
  constexpr std::string_view kOwn[] = {"channels",
                                       "compression",
                                       "dataWindow",
                                       "displayWindow",
                                       "lineOrder",
                                       "tiles",
                                       "type",
                                       "version",
                                       "name",
                                       "chunkCount",
                                       "view",
                                       "multiView",
                                       "preview",
                                       "envmap",
                                       "maxSamplesPerPixel",
                                       "idManifest",
                                       "dwaCompressionLevel",
                                       "BlenderMultiChannel"};
  // Mattes whose channels are not written.
  constexpr std::string_view kMattes = "cryptomatte/";
  return std::find(std::begin(kOwn), std::end(kOwn), name) != std::end(kOwn) ||
         name.compare(0, kMattes.size(), kMattes) == 0;
}

Imath::Box2i toBox(const PixelWindow& window) {
  return {{window.x, window.y}, {window.x + window.width - 1, window.y + window.height - 1}};
}

Imf::Header headerOf(const Image& shape, const ExrOrigin& origin) {
  Imf::Header header(shape.width, shape.height);
  const PictureWindows& windows = origin.windows;
  if (windows.data.width == shape.width && windows.data.height == shape.height) {
    header.dataWindow() = toBox(windows.data);
    header.displayWindow() = toBox(windows.display);
  }
  if (origin.attributes)
    for (auto attribute = origin.attributes->begin(); attribute != origin.attributes->end(); ++attribute)
      if (!staysBehind(attribute.name())) header.insert(attribute.name(), attribute.attribute());
  header.compression() = Imf::ZIP_COMPRESSION;
  return header;
}

/// Encodes samples of type T (half, float or std::uint32_t), interleaved like Image, as a complete file in
/// memory.
template <typename T>
std::string encode(Imf::Header header, const ChannelNames& names, const T* samples, Imf::PixelType type) {
  const Imath::Box2i window = header.dataWindow();
  const std::size_t width = std::size_t(window.max.x - window.min.x + 1);
  Imf::FrameBuffer buffer;
  const std::size_t xStride = names.size() * sizeof(T);
  for (std::size_t c = 0; c < names.size(); ++c) {
    header.channels().insert(names[c], Imf::Channel(type));
    buffer.insert(names[c], Imf::Slice::Make(type, samples + c, window, xStride, xStride * width));
  }
  Imf::StdOSStream stream;
  {
    Imf::OutputFile file(stream, header);  // its destructor completes the line offset table
    file.setFrameBuffer(buffer);
    file.writePixels(window.max.y - window.min.y + 1);
  }
  return stream.str();
}

std::string encode(const Image& image, const ChannelNames& names, ExrType type, const ExrOrigin& origin) {
  const Imf::Header header = headerOf(image, origin);
  if (type == ExrType::Float) return encode(header, names, image.pixels.data(), Imf::FLOAT);
  if (type == ExrType::Uint) {
    std::vector<std::uint32_t> ids(image.pixels.size());
    std::transform(image.pixels.begin(), image.pixels.end(), ids.begin(), toUint);
    return encode(header, names, ids.data(), Imf::UINT);
  }
  std::vector<half> samples(image.pixels.size());
  std::transform(image.pixels.begin(), image.pixels.end(), samples.begin(), toHalf);
  return encode(header, names, samples.data(), Imf::HALF);
}

}  // namespace

void writeExr(const std::string& path, const Image& image, ExrType type) {
  if (namesForWriting(image.channels).empty()) refuseShape(path, "an image of 1, 2 or 3 channels", image);
  writeExr(path, image, namesForWriting(image.channels), type);
}

void writeExr(const std::string& path, const Image& image, const std::vector<std::string>& channels,
              ExrType type) {
  writeExr(path, image, channels, type, {});
}

void writeExr(const std::string& path, const Image& image, const std::vector<std::string>& channels,
              ExrType type, const ExrOrigin& origin) {
  if (image.empty() || int(channels.size()) != image.channels)
    refuseShape(path, fmt::format("an image of {} channels", channels.size()), image);
  std::string bytes;
  try {
    bytes = encode(image, channels, type, origin);
  } catch (const std::exception& error) {
    throwFileError("write EXR", path, "to encode the image", error.what());
  }
  writeBinaryFile(path, bytes.data(), bytes.size());
}

}  // namespace quell::io
