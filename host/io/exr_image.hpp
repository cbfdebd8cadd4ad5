// OpenEXR images in and out: scan-line or tiled, first part, half, float or 32-bit integer channels.
#pragma once

#include <string>
#include <vector>

#include "host/io/image.hpp"

namespace quell::io {

/// How samples are stored. Half: 10 bits of mantissa, |value| <= 65504. Uint: 32 bits, whole numbers.
enum class ExrType { Half, Float, Uint };

/// What a file says about itself, without its pixels.
struct ExrHeader {
  int width = 0;                      ///< of the data window, pixels, >= 1
  int height = 0;                     ///< of the data window, pixels, >= 1
  std::vector<std::string> channels;  ///< names in alphabetical order, as the format keeps them
};

/// Reads the header alone. Throws Error(FileError): missing, not OpenEXR, damaged, or larger than 2^28
/// pixels.
ExrHeader readExrHeader(const std::string& path);

/// Reads the first of these channel sets that the file has: R G B, X Y Z, Y alone, R G. Pixel (0, 0) of the
/// image is the top left of the data window, wherever that lies. Samples come as they are, NaN and Inf
/// included. Throws Error(FileError): missing file, damaged or truncated file, none of the channel sets (says
/// which channels there are).
Image readExr(const std::string& path);

/// As readExr(), with the channels asked for, in that order (for example {"diffuse.R", "diffuse.G"}).
Image readExr(const std::string& path, const std::vector<std::string>& channels);

/// As readExr(), but a file without three channels (R G B or X Y Z) is refused with Error(FileError).
Image readExrRgb(const std::string& path);

/// Throws Error(InvalidArgument) naming `path`, the size expected and the size found, unless they agree.
void requireSize(const Image& image, int width, int height, const std::string& path);

/// Writes 3 channels as R G B, 2 as R G, or 1 as Y; ZIP compressed, atomically (see atomic_file.hpp). Half:
/// values beyond the range, Inf included, become +-65504; NaN stays NaN. Float: exact. Uint: rounded to the
/// nearest whole number in [0, 2^32 - 256], NaN becomes 0; a float in memory is exact up to 2^24.
/// Throws Error(InvalidArgument) for an empty image or another channel count, Error(FileError) if writing
/// fails.
void writeExr(const std::string& path, const Image& image, ExrType type = ExrType::Half);

/// The same with channels of these names, as many as the image has.
void writeExr(const std::string& path, const Image& image, const std::vector<std::string>& channels,
              ExrType type);

}  // namespace quell::io
