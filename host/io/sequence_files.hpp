// What the sequence layouts share: the frames of several files each, and images of one size.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/io/exr_file.hpp"
#include "host/io/frame_files.hpp"
#include "host/io/frame_sequence.hpp"
#include "host/io/image.hpp"

namespace quell::io {

/// Whether `name` exists in `directory` as something that can be opened as a file.
bool hasFile(const std::string& directory, const std::string& name);

/// Names of the entries of a directory that are `wanted`, sorted. Throws Error(FileError): it cannot be listed.
std::vector<std::string> listEntries(
    const std::string& directory,
    const std::function<bool(const std::filesystem::directory_entry& entry)>& wanted);

/// `directory` and `name` joined.
std::string joinPath(const std::string& directory, const std::string& name);

/// The frames of a sequence whose every frame needs a file of all of `required`, the first of which counts as the list of
/// frames. With MissingFrames::Skip those that lack one are left out, as gaps are.
/// Throws Error(FileError): no frame, a number that is missing in between, or a missing file (names it).
std::vector<int> framesOf(const std::vector<FrameFiles>& required, MissingFrames missing);

/// For a buffer that may be absent: false if no frame has the file, true if all have it.
/// Throws Error(FileError) naming the missing file where only some have it.
bool hasAll(const FrameFiles& files, const std::vector<int>& frames);

/// Marks a frame that follows a gap (afterGap), with a warning that lists what is missing.
void markGap(FrameData& frame, const std::vector<int>& frames, const std::string& missingFile);

/// Throws Error(InvalidArgument) unless `frame` is one of `frames`.
void requireFrame(const std::string& directory, const std::vector<int>& frames, int frame);

/// `jitterPx` if both numbers are within kMaxJitterPx. Throws Error(FileError) naming the file, the name of the numbers
/// in it, and the frame.
std::array<double, 2> requireJitter(const std::string& path, const char* name, int frame,
                                    std::array<double, 2> jitterPx);

/// Throws what readWithin() throws for the windows and the channels of a file, but looks at no pixels.
void requireWithin(const ExrFile& file, const std::vector<std::string>& channels,
                   const PictureWindows& picture);
/// Reads channels as ExrFile::read() from a file of the picture whose windows are given; pixels that lie elsewhere
/// than its data window are placed by window. What the file does not cover is 0, with a warning.
/// Throws Error(FileError), or Error(InvalidArgument) naming the file: another display window, or no pixel in common.
Image readWithin(const ExrFile& file, const std::vector<std::string>& channels, const PictureWindows& picture,
                 std::vector<FrameWarning>& warnings);
/// Names of channels of one letter each, as in ImageFiles; none for "RGB", in whose place X Y Z will do.
std::vector<std::string> channelsOfLetters(const std::string& letters);
/// Throws Error(InvalidArgument) naming the file unless its picture has these windows.
void requireWindows(const std::string& path, const PictureWindows& windows, const PictureWindows& expected);
/// Of the file of the colour, whose windows must be these. Throws as requireWindows().
ExrOrigin originOf(const ExrFile& file, const PictureWindows& expected);

}  // namespace quell::io
