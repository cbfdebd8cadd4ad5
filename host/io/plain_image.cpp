#include "host/io/plain_image.hpp"

#include <fmt/format.h>
#include <half.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "host/io/atomic_file.hpp"
#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

constexpr char kReadPfm[] = "read PFM";
/// As for OpenEXR files: beyond it a header is taken for damaged.
constexpr std::int64_t kMaxPixels = std::int64_t(1) << 28;
constexpr int kRgb = 3;

/// Words between white space at the beginning of a file.
class Words {
 public:
  explicit Words(std::string_view text) : m_text(text) {}

  std::string_view next() {
    while (m_at < m_text.size() && std::isspace(static_cast<unsigned char>(m_text[m_at]))) ++m_at;
    const std::size_t begin = m_at;
    while (m_at < m_text.size() && !std::isspace(static_cast<unsigned char>(m_text[m_at]))) ++m_at;
    return m_text.substr(begin, m_at - begin);
  }
  /// Where the bytes after the one white space that ends the header begin.
  std::size_t afterHeader() const { return m_at + 1; }

 private:
  std::string_view m_text;
  std::size_t m_at = 0;
};

template <class Number>
bool parse(std::string_view word, Number& number) {
  const auto result = std::from_chars(word.data(), word.data() + word.size(), number);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

struct PfmHeader {
  int width = 0, height = 0, channels = 0;
  float scale = 0.0f;  ///< negative: little-endian
  std::size_t begin = 0;
};

PfmHeader parseHeader(const std::string& bytes, const std::string& path) {
  Words words(bytes);
  PfmHeader header;
  const std::string_view kind = words.next();
  header.channels = kind == "PF" ? 3 : kind == "Pf" ? 1 : kind == "PF4" ? 4 : 0;
  const bool sizes = parse(words.next(), header.width) && parse(words.next(), header.height) &&
                     header.width > 0 && header.height > 0;
  const bool scale = parse(words.next(), header.scale) && std::isfinite(header.scale) && header.scale != 0.0f;
  header.begin = words.afterHeader();
  if (header.channels == 0 || !sizes || !scale || header.width > kMaxPixels / header.height)
    throwFileError(kReadPfm, path, "PF or Pf, a width, a height and a scale", "another header");
  return header;
}

std::uint32_t swapped(std::uint32_t x) {
  return x >> 24 | (x >> 8 & 0xff00u) | (x << 8 & 0xff0000u) | x << 24;
}

float floatAt(const char* bytes, bool bigEndian) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, bytes, sizeof(bits));
  if (bigEndian) bits = swapped(bits);
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

float halfAt(const char* bytes) {
  half value;
  std::memcpy(static_cast<void*>(&value), bytes, sizeof(value));
  return float(value);
}

}  // namespace

Image readPfm(const std::string& path) {
  const std::string bytes = readFile(path);
  const PfmHeader header = parseHeader(bytes, path);
  const std::size_t row = std::size_t(header.width) * std::size_t(header.channels) * sizeof(float);
  if (bytes.size() != header.begin + row * std::size_t(header.height))
    throwFileError(kReadPfm, path, fmt::format("{} bytes", header.begin + row * std::size_t(header.height)),
                   fmt::format("{}", bytes.size()));
  Image image(header.width, header.height, kRgb);
  for (int y = 0; y < header.height; ++y) {
    const char* samples = bytes.data() + header.begin + row * std::size_t(header.height - 1 - y);
    for (int x = 0; x < header.width; ++x)
      for (int c = 0; c < kRgb; ++c) {
        const int sample = x * header.channels + (header.channels == 1 ? 0 : c);
        image.at(x, y, c) = std::abs(header.scale) *
                            floatAt(samples + std::size_t(sample) * sizeof(float), header.scale > 0.0f);
      }
  }
  return image;
}

void writePfm(const std::string& path, const Image& image) {
  if (image.empty() || (image.channels != kRgb && image.channels != 1))
    throw Error(ErrorCode::InvalidArgument,
                {"write PFM", path, "an image of 1 or 3 channels",
                 fmt::format("{}x{} pixels of {} channels", image.width, image.height, image.channels)});
  std::string bytes =
      fmt::format("{}\n{} {}\n-1.0\n", image.channels == 1 ? "Pf" : "PF", image.width, image.height);
  const std::size_t row = std::size_t(image.width) * std::size_t(image.channels);
  for (int y = image.height - 1; y >= 0; --y)
    bytes.append(reinterpret_cast<const char*>(image.pixels.data() + row * std::size_t(y)),
                 row * sizeof(float));
  writeBinaryFile(path, bytes.data(), bytes.size());
}

Image readRaw(const std::string& path, int width, int height) {
  const std::string bytes = readFile(path);
  Image image(width, height, kRgb);
  const std::size_t pixels = image.pixels.size() / kRgb;
  for (const std::size_t channels : {3, 4}) {
    for (const std::size_t size : {sizeof(float), sizeof(half)}) {
      if (bytes.size() != pixels * channels * size) continue;
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const char* sample = bytes.data() + (i / kRgb * channels + i % kRgb) * size;
        image.pixels[i] = size == sizeof(float) ? floatAt(sample, false) : halfAt(sample);
      }
      return image;
    }
  }
  throwFileError("read raw samples", path,
                 fmt::format("{}x{} pixels of 3 or 4 floats or halves, so {}, {}, {} or {} bytes", width,
                             height, 12 * pixels, 16 * pixels, 6 * pixels, 8 * pixels),
                 fmt::format("{} bytes", bytes.size()));
}

}  // namespace quell::io
