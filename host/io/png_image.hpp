// 8-bit PNG pictures for viewing. Values are display-encoded in [0, 1]; nothing here applies or removes a
// gamma.
#pragma once

#include <string>

#include "host/io/image.hpp"

namespace quell::io {

/// The bytes of a PNG file: 3 channels of display-encoded values as 8-bit RGB, clamped to [0, 1], rounded to
/// nearest, NaN as 0. Throws Error(InvalidArgument) unless the image has 3 channels and at least one pixel.
std::string encodePng(const Image& rgbEncoded);

/// Writes what encodePng() gives. Atomic (see atomic_file.hpp). Throws as encodePng(), and Error(FileError) if writing
/// fails.
void writePng(const std::string& path, const Image& rgbEncoded);

/// Reads a PNG of any colour type and depth as 3 channels in [0, 1]: grey is repeated, palettes are looked
/// up, alpha is dropped without blending, 16 bits keep their precision; gamma and colour profile chunks are
/// ignored. Throws Error(FileError): missing, damaged, truncated, or larger than 2^28 pixels.
Image readPng(const std::string& path);

}  // namespace quell::io
