// What the sequence layouts share: finding numbered files and reading images of one size.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "host/io/image.hpp"

namespace quell::io {

/// File name (without directory) of a frame number, for example 7 -> "color_0007.exr".
using FrameFileName = std::function<std::string(int frame)>;

/// Whether `name` exists in `directory` as something that can be opened as a file.
bool hasFile(const std::string& directory, const std::string& name);

/// `directory` and `name` joined.
std::string joinPath(const std::string& directory, const std::string& name);

/// The frame numbers, ascending, for which `fileName` is in the directory.
/// Throws Error(FileError): the directory cannot be listed, no such file, or a number is missing in between.
std::vector<int> findFrames(const std::string& directory, const FrameFileName& fileName);

/// Throws Error(FileError) naming the first frame without such a file.
void requireFrameFiles(const std::string& directory, const FrameFileName& fileName,
                       const std::vector<int>& frames);

/// For a buffer that may be absent: false if no frame has the file, true if all have it.
/// Throws Error(FileError) naming the missing file where only some have it.
bool hasFrameFiles(const std::string& directory, const FrameFileName& fileName,
                   const std::vector<int>& frames);

/// Throws Error(InvalidArgument) unless `frame` is one of `frames`.
void requireFrame(const std::string& directory, const std::vector<int>& frames, int frame);

/// `jitterPx` if both numbers are within kMaxJitterPx. Throws Error(FileError) naming the file, the name of the numbers
/// in it, and the frame.
std::array<double, 2> requireJitter(const std::string& path, const char* name, int frame,
                                    std::array<double, 2> jitterPx);

/// Reads channels of these names from an OpenEXR file that must have the given size.
/// Throws Error(FileError), or Error(InvalidArgument) naming the file, the size expected and the size found.
Image readChannelsOfSize(const std::string& path, const std::vector<std::string>& channels, int width,
                         int height);
/// The same for channels of one letter each, as in ImageFiles; "RGB" takes X Y Z as well.
Image readLettersOfSize(const std::string& path, const std::string& letters, int width, int height);

}  // namespace quell::io
