#include "host/io/exr_passes.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStdIO.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_open.hpp"
#include "host/io/exr_samples.hpp"

namespace quell::io {
namespace {

constexpr char kCombined[] = "Combined";

/// The pixels of a part and where they are.
struct Part {
  Imf::Header header;
  Imf::FrameBuffer buffer;
  std::vector<std::vector<char>> planes;
};

Imf::PixelType pixelType(ExrType type) {
  return type == ExrType::Half ? Imf::HALF : type == ExrType::Float ? Imf::FLOAT : Imf::UINT;
}

std::size_t sizeOf(Imf::PixelType type) { return type == Imf::HALF ? 2 : 4; }

/// Adds a plane for a channel to a part whose header has it; its samples are `bytes`, or zero.
void addPlane(Part& part, const std::string& name, const Imf::Channel& channel,
              std::vector<char> bytes = {}) {
  const Imath::Box2i window = part.header.dataWindow();
  const std::size_t columns = std::size_t((window.max.x - window.min.x) / channel.xSampling) + 1;
  const std::size_t rows = std::size_t((window.max.y - window.min.y) / channel.ySampling) + 1;
  const std::size_t stride = sizeOf(channel.type);
  bytes.resize(columns * rows * stride);
  part.planes.push_back(std::move(bytes));
  part.buffer.insert(name, Imf::Slice::Make(channel.type, part.planes.back().data(), window, stride,
                                            stride * columns, channel.xSampling, channel.ySampling));
}

/// A header for lines, whatever a part came as. Attributes are left out here, since OpenEXR 3.1 leaks what it erases.
Imf::Header headerOfLines(const Imf::Header& from) {
  Imf::Header header;
  for (auto attribute = from.begin(); attribute != from.end(); ++attribute) {
    const std::string name = attribute.name();
    if (name != "tiles" && name != "chunkCount") header.insert(name, attribute.attribute());
  }
  header.setType(Imf::SCANLINEIMAGE);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.lineOrder() = Imf::INCREASING_Y;
  return header;
}

Part readPart(Imf::MultiPartInputFile& file, int index) {
  Part part;
  part.header = headerOfLines(file.header(index));
  const Imf::ChannelList& channels = part.header.channels();
  for (auto channel = channels.begin(); channel != channels.end(); ++channel)
    addPlane(part, channel.name(), channel.channel());
  Imf::InputPart input(file, index);
  input.setFrameBuffer(part.buffer);
  const Imath::Box2i window = part.header.dataWindow();
  input.readPixels(window.min.y, window.max.y);
  return part;
}

template <class Sample, class Convert>
std::vector<char> bytesOf(const Image& image, std::size_t channel, Convert convert) {
  const std::size_t channels = std::size_t(image.channels), pixels = image.pixels.size() / channels;
  std::vector<char> bytes(pixels * sizeof(Sample));
  for (std::size_t i = 0; i < pixels; ++i) {
    const Sample sample = convert(image.pixels[i * channels + channel]);
    std::memcpy(bytes.data() + i * sizeof(Sample), &sample, sizeof(Sample));
  }
  return bytes;
}

std::vector<char> bytesOf(const Image& image, std::size_t channel, ExrType type) {
  if (type == ExrType::Half) return bytesOf<half>(image, channel, toHalf);
  if (type == ExrType::Uint) return bytesOf<std::uint32_t>(image, channel, toUint);
  return bytesOf<float>(image, channel, [](float value) { return value; });
}

/// Adds the channels of a pass to a part. Throws std::exception.
void addPass(Part& part, const NamedPass& pass, bool namesPart) {
  const Imath::Box2i window = part.header.dataWindow();
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  if (pass.image.width != width || pass.image.height != height)
    throw std::invalid_argument(fmt::format("a pass {} of {}x{} pixels beside {}x{}", pass.name,
                                            pass.image.width, pass.image.height, width, height));
  for (std::size_t c = 0; c < pass.channels.size(); ++c) {
    const std::string name = namesPart ? pass.channels[c] : pass.name + "." + pass.channels[c];
    if (part.header.channels().findChannel(name) != nullptr)
      throw std::invalid_argument("two channels " + name);
    const Imf::Channel channel(pixelType(pass.samples));
    part.header.channels().insert(name, channel);
    addPlane(part, name, channel, bytesOf(pass.image, c, pass.samples));
  }
}

/// The header of the first part of the pass's size, if there is one.
Imf::Header likePass(const std::vector<Part>& parts, const NamedPass& pass) {
  const auto fitsPass = [&](const Part& part) {
    const Imath::Box2i window = part.header.dataWindow();
    return window.max.x - window.min.x + 1 == pass.image.width &&
           window.max.y - window.min.y + 1 == pass.image.height;
  };
  const auto found = std::find_if(parts.begin(), parts.end(), fitsPass);
  return found == parts.end() ? parts.front().header : found->header;
}

void writeParts(const std::string& output, const std::vector<Part>& parts) {
  std::vector<Imf::Header> headers;
  for (const Part& part : parts) headers.push_back(part.header);
  Imf::StdOSStream stream;
  {
    Imf::MultiPartOutputFile file(stream, headers.data(), int(headers.size()));
    for (int i = 0; i < int(parts.size()); ++i) {
      Imf::OutputPart part(file, i);
      const Imath::Box2i window = parts[std::size_t(i)].header.dataWindow();
      part.setFrameBuffer(parts[std::size_t(i)].buffer);
      part.writePixels(window.max.y - window.min.y + 1);
    }
  }
  const std::string bytes = stream.str();
  writeBinaryFile(output, bytes.data(), bytes.size());
}

}  // namespace

std::string passBeside(const std::vector<std::string>& channels, const std::string& name) {
  for (const std::string& channel : channels) {
    const std::size_t at = channel.rfind(kCombined);
    if (at != std::string::npos && (at == 0 || channel[at - 1] == '.')) return channel.substr(0, at) + name;
  }
  return name;
}

void writeWithPasses(const std::string& input, const std::string& output,
                     const std::vector<NamedPass>& passes) {
  withExrErrors(input, [&] {
    Imf::MultiPartInputFile file = openExr(input);
    std::vector<Part> parts;
    parts.reserve(std::size_t(file.parts()) + passes.size());  // frame buffers point into them
    for (int i = 0; i < file.parts(); ++i) parts.push_back(readPart(file, i));
    const bool single = parts.size() == 1;
    for (const NamedPass& pass : passes) {
      if (!single) {
        const Imf::Header like = likePass(parts, pass);
        parts.emplace_back();
        parts.back().header = like;
        parts.back().header.channels() = Imf::ChannelList();
        parts.back().header.setName(pass.name);
      }
      addPass(single ? parts.front() : parts.back(), pass, !single);
    }
    writeParts(output, parts);
  });
}

}  // namespace quell::io
