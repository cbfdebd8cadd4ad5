#include "host/io/exr_attributes.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace quell::io {
namespace {

struct TypeLength {
  const char* type;
  std::size_t bytes;
};

/// Types whose attributes have one length (OpenEXR file layout, attribute types).
constexpr TypeLength kLengths[] = {{"box2i", 16},
                                   {"box2f", 16},
                                   {"chromaticities", 32},
                                   {"compression", 1},
                                   {"deepImageState", 1},
                                   {"double", 8},
                                   {"envmap", 1},
                                   {"float", 4},
                                   {"int", 4},
                                   {"keycode", 28},
                                   {"lineOrder", 1},
                                   {"m33f", 36},
                                   {"m33d", 72},
                                   {"m44f", 64},
                                   {"m44d", 128},
                                   {"rational", 8},
                                   {"tiledesc", 9},
                                   {"timecode", 8},
                                   {"v2i", 8},
                                   {"v2f", 8},
                                   {"v2d", 16},
                                   {"v3i", 12},
                                   {"v3f", 12},
                                   {"v3d", 24}};

/// Little-endian, as all numbers of the format.
std::int32_t readInt(std::istream& file) {
  unsigned char bytes[4] = {};
  file.read(reinterpret_cast<char*>(bytes), sizeof(bytes));
  return static_cast<std::int32_t>(bytes[0] | bytes[1] << 8 | bytes[2] << 16 |
                                   static_cast<std::uint32_t>(bytes[3]) << 24);
}

/// OpenEXR goes on to the next attribute where the list of channels ends, not where the header says that it does.
void requireChannelListEnds(const std::string& list) {
  constexpr std::size_t kChannelBytes = 16;  // type, linearity and two samplings after its name
  std::size_t position = 0;
  while (position < list.size() && list[position] != '\0') {
    const std::size_t end = list.find('\0', position);
    position = end == std::string::npos ? list.size() : end + 1 + kChannelBytes;
  }
  if (position + 1 != list.size())
    throw std::length_error(fmt::format("a list of channels that is not {} bytes long", list.size()));
}

/// OpenEXR goes on where what it reads of a type ends, not where the header says that the attribute does.
void requireLength(const std::string& type, const std::string& value) {
  if (type == "chlist") requireChannelListEnds(value);
  for (const TypeLength& known : kLengths)
    if (type == known.type && value.size() != known.bytes)
      throw std::length_error(fmt::format("an attribute of type {} with {} bytes instead of {}", type,
                                          value.size(), known.bytes));
}

}  // namespace

void requireAttributesWithin(const std::string& path, std::int64_t fileBytes) {
  constexpr std::int32_t kSeveralParts = 0x1000;
  std::ifstream file(path, std::ios::binary);
  readInt(file);  // the magic number
  const bool severalParts = (readInt(file) & kSeveralParts) != 0;
  for (std::string name, type; std::getline(file, name, '\0');) {
    if (name.empty() && (!severalParts || file.peek() == 0)) return;
    if (name.empty()) continue;  // the header of another part
    std::getline(file, type, '\0');
    const std::int32_t bytes = readInt(file);
    if (!file) return;  // OpenEXR has its own words for files that end early
    if (bytes < 0 || bytes > fileBytes - std::int64_t(file.tellg()))
      throw std::length_error(
          fmt::format("an attribute of {} bytes in a file of {} bytes", bytes, fileBytes));
    std::string value(static_cast<std::size_t>(bytes), '\0');
    file.read(value.data(), bytes);
    requireLength(type, value);
  }
}

}  // namespace quell::io
