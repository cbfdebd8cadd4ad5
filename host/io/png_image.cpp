#include "host/io/png_image.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "host/io/atomic_file.hpp"
#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

constexpr char kReadStage[] = "read PNG";
/// Images beyond this many pixels (16384 x 16384) are taken for damaged headers rather than allocated.
constexpr std::uint64_t kMaxPixels = std::uint64_t(1) << 28;
constexpr int kChannels = 3;
constexpr float kMaxByte = 255.0f;    // largest 8-bit sample
constexpr float kMaxWord = 65535.0f;  // largest 16-bit sample

png_byte toByte(float encoded) {
  if (std::isnan(encoded)) return 0;
  return png_byte(std::lround(std::clamp(encoded, 0.0f, 1.0f) * kMaxByte));
}

/// What libpng reads from: the file in memory and how far it has come.
struct ByteSource {
  const std::string& bytes;
  std::size_t position = 0;
};

/// State of one decode. It outlives the longjmp with which libpng reports errors, so that the functions which
/// call setjmp own nothing that needs a destructor.
struct Decoder {
  explicit Decoder(const std::string& bytes) : source{bytes} {}
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }

  ByteSource source;
  png_structp png = nullptr;
  png_infop info = nullptr;
  char message[160] = "out of memory";
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  int bitDepth = 0;
  std::vector<png_byte> samples;
  std::vector<png_bytep> rows;
};

[[noreturn]] void onError(png_structp png, png_const_charp text) {
  auto* decoder = static_cast<Decoder*>(png_get_error_ptr(png));
  std::snprintf(decoder->message, sizeof decoder->message, "%s", text);
  png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void onRead(png_structp png, png_bytep target, std::size_t size) {
  auto* source = static_cast<ByteSource*>(png_get_io_ptr(png));
  if (size > source->bytes.size() - source->position) png_error(png, "the file ends too early");
  std::copy_n(source->bytes.data() + source->position, size, target);
  source->position += size;
}

/// Reads the header and asks for 8- or 16-bit RGB rows whatever the file holds. False: see decoder.message.
bool readHeader(Decoder& decoder) {
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, onError, onWarning);
  if (!decoder.png) return false;
  decoder.info = png_create_info_struct(decoder.png);
  if (!decoder.info) return false;
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  png_set_read_fn(decoder.png, &decoder.source, onRead);
  png_read_info(decoder.png, decoder.info);
  png_set_expand(decoder.png);
  png_set_gray_to_rgb(decoder.png);
  png_set_strip_alpha(decoder.png);
  png_set_interlace_handling(decoder.png);
  png_read_update_info(decoder.png, decoder.info);
  decoder.width = png_get_image_width(decoder.png, decoder.info);
  decoder.height = png_get_image_height(decoder.png, decoder.info);
  decoder.bitDepth = png_get_bit_depth(decoder.png, decoder.info);
  return true;
}

void allocateRows(Decoder& decoder) {
  const std::size_t rowBytes = png_get_rowbytes(decoder.png, decoder.info);
  decoder.samples.resize(rowBytes * decoder.height);
  decoder.rows.resize(decoder.height);
  for (std::size_t y = 0; y < decoder.rows.size(); ++y)
    decoder.rows[y] = decoder.samples.data() + y * rowBytes;
}

bool readRows(Decoder& decoder) {
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  png_read_image(decoder.png, decoder.rows.data());
  png_read_end(decoder.png, nullptr);
  return true;
}

/// PNG keeps 16-bit samples with the high byte first.
Image toImage(const Decoder& decoder) {
  Image image(int(decoder.width), int(decoder.height), kChannels);
  const bool isWide = decoder.bitDepth > 8;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const png_byte* sample = decoder.samples.data() + (isWide ? 2 * i : i);
    image.pixels[i] = isWide ? float(sample[0] * 256 + sample[1]) / kMaxWord : float(sample[0]) / kMaxByte;
  }
  return image;
}

}  // namespace

std::string encodePng(const Image& rgbEncoded) {
  if (rgbEncoded.empty() || rgbEncoded.channels != kChannels)
    throw Error(ErrorCode::InvalidArgument, {"write PNG", "", "an image of 3 channels",
                                             fmt::format("{}x{} pixels of {} channels", rgbEncoded.width,
                                                         rgbEncoded.height, rgbEncoded.channels)});
  std::vector<png_byte> samples(rgbEncoded.pixels.size());
  std::transform(rgbEncoded.pixels.begin(), rgbEncoded.pixels.end(), samples.begin(), toByte);

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(rgbEncoded.width);
  png.height = png_uint_32(rgbEncoded.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string file(size, '\0');
  if (!png_image_write_to_memory(&png, file.data(), &size, 0, samples.data(), 0, nullptr))
    throwFileError("write PNG", "", "to encode the picture", png.message);
  file.resize(size);
  return file;
}

void writePng(const std::string& path, const Image& rgbEncoded) {
  const std::string file = encodePng(rgbEncoded);
  writeBinaryFile(path, file.data(), file.size());
}

Image readPng(const std::string& path) {
  const std::string bytes = readFile(path);
  Decoder decoder(bytes);
  if (!readHeader(decoder)) throwFileError(kReadStage, path, "a PNG picture", decoder.message);
  if (std::uint64_t(decoder.width) * decoder.height > kMaxPixels)
    throwFileError(kReadStage, path, "at most 2^28 pixels",
                   fmt::format("{}x{}", decoder.width, decoder.height));
  allocateRows(decoder);
  if (!readRows(decoder)) throwFileError(kReadStage, path, "a complete PNG picture", decoder.message);
  return toImage(decoder);
}

}  // namespace quell::io
