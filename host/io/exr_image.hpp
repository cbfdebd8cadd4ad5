// OpenEXR images in and out: scan-line or tiled, of one part or several, half, float or 32-bit integer channels.
#pragma once

#include <string>
#include <vector>

#include "host/io/exr_header.hpp"
#include "host/io/image.hpp"

namespace quell::io {

/// How samples are stored. Half: 10 bits of mantissa, |value| <= 65504. Uint: 32 bits, whole numbers.
enum class ExrType { Half, Float, Uint };

/// Reads the first of these channel sets that a part of the file has: R G B, X Y Z, Y alone, R G. Pixel (0, 0) of the
/// image is the top left of the data window, wherever that lies. Samples come as they are, NaN and Inf
/// included. Throws Error(FileError): missing file, damaged or truncated file, none of the channel sets (says
/// which channels there are).
Image readExr(const std::string& path);

/// As readExr(), with the channels asked for, in that order (for example {"diffuse.R", "diffuse.G"}), of whatever parts;
/// names as in ExrHeader::channels. Parts with other windows than the first of these are placed by window.
Image readExr(const std::string& path, const std::vector<std::string>& channels);

/// As readExr(), but a file without three channels (R G B or X Y Z) is refused with Error(FileError).
Image readExrRgb(const std::string& path);

/// Writes 3 channels as R G B, 2 as R G, or 1 as Y; ZIP compressed, atomically (see atomic_file.hpp). Half:
/// values beyond the range, Inf included, become +-65504; NaN stays NaN. Float: exact. Uint: rounded to the
/// nearest whole number in [0, 2^32 - 256], NaN becomes 0; a float in memory is exact up to 2^24.
/// Throws Error(InvalidArgument) for an empty image or another channel count, Error(FileError) if writing
/// fails.
void writeExr(const std::string& path, const Image& image, ExrType type = ExrType::Half);

/// The same with channels of these names, as many as the image has.
void writeExr(const std::string& path, const Image& image, const std::vector<std::string>& channels,
              ExrType type);

/// The same, with the windows and the attributes of another file. What speaks of its channels, parts, samples or preview
/// stays behind.
void writeExr(const std::string& path, const Image& image, const std::vector<std::string>& channels,
              ExrType type, const ExrOrigin& origin);

}  // namespace quell::io
