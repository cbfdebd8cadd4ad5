// Uncompressed floats, as other denoisers read and write them: PFM, and raw samples without a header.
#pragma once

#include <string>

#include "host/io/image.hpp"

namespace quell::io {

/// Reads a Portable FloatMap (P. Debevec; "PF", "Pf", or "PF4" with a fourth channel) as 3 channels: grey is repeated, a
/// fourth channel dropped; either byte order; samples are multiplied with the scale of the header. Rows are stored from
/// bottom to top, the image here begins at the top. Throws Error(FileError): missing, malformed, of another length than its
/// header says, or larger than 2^28 pixels.
Image readPfm(const std::string& path);

/// Writes 3 channels as "PF" or 1 as "Pf", little-endian, scale 1, exactly; atomic (see atomic_file.hpp). Throws
/// Error(InvalidArgument) for other channel counts, Error(FileError).
void writePfm(const std::string& path, const Image& image);

/// Reads interleaved little-endian samples from the top left on as 3 channels: RGB or RGBA, floats or halves; which it is
/// follows from the length. Throws Error(FileError): missing, or of a length that fits none of them.
Image readRaw(const std::string& path, int width, int height);

}  // namespace quell::io
