// Names of files around the numbers of their frames (frame_files.hpp says which number counts).
#pragma once

#include <string>

namespace quell::io {

/// What fits an int.
constexpr int kMostFrameDigits = 9;

/// A file's name around the number of its frame.
struct NumberedName {
  std::string prefix, suffix;
  int frame = 0;
  int digits = 0;  ///< 0: a name without a number
};

NumberedName splitName(const std::string& name);

/// What files of one sequence have in common; no name has a '/'. The case of the extension does not count.
std::string keyOf(const std::string& prefix, const std::string& suffix, bool numbered);

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
std::string lowerCase(std::string text);  ///< of ASCII alone

}  // namespace quell::io
