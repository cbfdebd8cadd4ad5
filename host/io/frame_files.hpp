// Files numbered by frame: which file is which frame, however the numbers are padded.
//
// The number is the last digits before the extension, at most kMostFrameDigits of them (frame_names.hpp); where a name does not end with
// digits, the last ones that stand by themselves between '.', '_', '-' and blanks ("0001_ALBEDO.exr", "shot.0001.N.exr").
// A '-' in front is its sign where no letter or digit stands before that ("-0001.exr", "color_-0001.exr"), else part of the
// name ("shot-0001.exr").
// Files of equal text around the number are one sequence, the case of the extension apart; order is that of the numbers.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace quell::io {

/// What becomes of a sequence that lacks frames.
enum class MissingFrames {
  Refuse,
  Skip,  ///< what is there is read; a frame after a gap has FrameData::afterGap
};

/// With four digits at least: "0007", "-0012".
std::string paddedFrame(int frame);

/// The numbers that are missing between the first and the last of `frames` (ascending), for messages: "no frames 3, 5 to 9",
/// the first few; empty where none is.
std::string missingText(const std::vector<int>& frames);

/// The files of one sequence.
class FrameFiles {
 public:
  FrameFiles() = default;
  FrameFiles(std::string directory, std::string prefix, std::string suffix);

  /// `name` is a file of the directory; `digits` those of its number, 0: none. Throws Error(FileError) naming both files if
  /// the frame has one.
  void add(int frame, const std::string& name, int digits);

  bool empty() const { return m_names.empty(); }
  bool has(int frame) const { return m_names.count(frame) > 0; }
  std::vector<int> frames() const;  ///< ascending
  const std::string& directory() const { return m_directory; }
  const std::string& prefix() const { return m_prefix; }
  const std::string& suffix() const { return m_suffix; }  ///< with the extension
  /// The frame's number as its file has it, sign and padding included; empty where it has none.
  std::string numberText(int frame) const;
  /// Path of the frame's file, or the one that it would have.
  std::string path(int frame) const;
  /// Path with a '#' for each digit, as openSequence() takes it.
  std::string pattern() const;

  /// Throws Error(FileError) unless there is a file, and none is missing in between.
  void requireNoGaps() const;
  /// Throws Error(FileError) naming the first of `frames` without a file.
  void requireAll(const std::vector<int>& frames) const;

 private:
  std::string m_directory, m_prefix, m_suffix;
  std::map<int, std::string> m_names;
  int m_digits = 0;  ///< of the shortest number
};

/// The OpenEXR files of a directory, listed once.
class FrameDirectory {
 public:
  /// Throws Error(FileError): it cannot be listed, or two files have the same number.
  explicit FrameDirectory(std::string path);

  /// Those whose names begin so and go on with the number; empty where there are none.
  const FrameFiles& withPrefix(const std::string& prefix) const;
  /// All of them, a file without a number as a sequence of its own with frame 0; by their patterns.
  std::vector<FrameFiles> all() const;

 private:
  std::string m_path;
  mutable std::map<std::string, FrameFiles> m_byKey;  ///< what was asked for in vain is empty
};

/// A file by itself; frame 0 where its name has no number.
FrameFiles oneFile(const std::string& path);

/// Whether the last part of a path stands for several files: '#' for each digit, "%d" or "%04d", or a glob (* ? [).
bool isFramePattern(const std::string& path);

/// The files that a pattern stands for. Throws Error(FileError): none, or two sequences (names both).
FrameFiles findFrameFiles(const std::string& pattern);

/// Files by name, as shells make them of a glob. Throws Error(FileError): one that is no file, or two sequences.
FrameFiles listedFiles(const std::vector<std::string>& paths);

/// The one of several sequences. Throws Error(FileError) naming two of them and how to choose; `all` has one or more.
FrameFiles requireOneSequence(const std::string& path, const std::vector<FrameFiles>& all);

}  // namespace quell::io
