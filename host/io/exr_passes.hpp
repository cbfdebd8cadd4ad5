// OpenEXR files with further passes beside those that they have.
#pragma once

#include <string>
#include <vector>

#include "host/io/exr_image.hpp"
#include "host/io/image.hpp"

namespace quell::io {

/// An image that becomes channels NAME.CHANNEL of a file.
struct NamedPass {
  std::string name;                   ///< as "View Layer.Denoised"
  std::vector<std::string> channels;  ///< last part of their names
  Image image;                        ///< of as many channels
  ExrType samples = ExrType::Half;
};

/// Name of a pass that stands for what a renderer calls the picture as a whole: "View Layer.Denoised" where `channels`
/// have "View Layer.Combined.R", "Denoised" where it stands alone.
std::string passBeside(const std::vector<std::string>& channels, const std::string& name);

/// Writes the OpenEXR file `input` anew as `output`, all parts, channels and attributes, and `passes` as channels of a
/// single part, or as a part each with the data window of the first part of their size. ZIP compressed, tiles become lines;
/// atomic. Throws Error(FileError): unreadable or deep input, a pass of another size, a name that is there already, or
/// writing fails.
void writeWithPasses(const std::string& input, const std::string& output,
                     const std::vector<NamedPass>& passes);

}  // namespace quell::io
