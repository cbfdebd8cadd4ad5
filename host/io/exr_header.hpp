// What OpenEXR files say about themselves, of one part or several, without their pixels.
#pragma once

#include <ImfForward.h>

#include <memory>
#include <string>
#include <vector>

#include "host/io/pixel_window.hpp"

namespace quell::io {

/// One part of a file; most files have one.
struct ExrPart {
  std::string name;  ///< empty where the part has none
  std::string view;  ///< "left", "right", ...; empty where the part has none
  PixelWindow data;
  std::vector<std::string> channels;  ///< as stored, in alphabetical order
};

/// Attributes of a file, to be carried over to files made from it: owner, time code, chromaticities, comments, ...
using ExrAttributes = std::shared_ptr<const Imf::Header>;

/// What a written file takes over from the one that its picture was made from.
struct ExrOrigin {
  PictureWindows
      windows;  ///< those of the picture at (0, 0) where `windows.data` has another size than the image
  ExrAttributes attributes;  ///< nothing: none
};

struct ExrHeader {
  int width = 0;   ///< of the data window of the first part, pixels, >= 1
  int height = 0;  ///< of the data window of the first part, pixels, >= 1
  PictureWindows windows;
  std::vector<ExrPart> parts;         ///< at least one
  std::vector<std::string> channels;  ///< names in all parts, see nameInFile()
  std::vector<std::string> views;     ///< names listed in the attribute multiView or of parts
  ExrAttributes attributes;           ///< of the first part
};

/// The name of a channel among those of all parts: as stored if it has a dot or the file one part, otherwise
/// PART.CHANNEL, or CHANNEL where both are called the same. Where a part is of one view, that stands before the last dot, as in files of one part: PASS.left.R.
std::string nameInFile(const ExrHeader& header, const ExrPart& part, const std::string& channel);

/// Reads the header alone. Throws Error(FileError): missing, not OpenEXR, damaged, deep, larger than 2^28 pixels, or too
/// short for as many lines as it claims.
ExrHeader readExrHeader(const std::string& path);

/// Throws Error(FileError) where lines are missing, as in files that are still being written or were cut off, without
/// decoding any. The header must be plausible; tiles are not looked at.
void requireAllLines(const std::string& path);

/// The header of a file that is open already, `headers` being those of its parts.
ExrHeader describe(const std::vector<Imf::Header>& headers);

/// Throws std::exception where a file is not worth opening: memory for the table of its lines would be taken before its
/// header is doubted. Takes none itself.
void requirePlausibleHeader(const std::string& path);

}  // namespace quell::io
