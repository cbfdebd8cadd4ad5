#include "host/io/frame_names.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

namespace quell::io {
namespace {

/// Bytes beyond ASCII belong to letters of UTF-8.
bool isLetterOrDigit(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

/// Digits from `begin` to `end`, negative if a sign stands before them that no letter or digit precedes.
NumberedName splitAt(const std::string& name, std::size_t begin, std::size_t end) {
  NumberedName split;
  std::from_chars(name.data() + begin, name.data() + end, split.frame);
  split.digits = int(end - begin);
  split.suffix = name.substr(end);
  const bool negative =
      begin > 0 && name[begin - 1] == '-' && (begin == 1 || !isLetterOrDigit(name[begin - 2]));
  if (negative) split.frame = -split.frame;
  split.prefix = name.substr(0, negative ? begin - 1 : begin);
  return split;
}

bool isSeparator(char c) { return std::string_view("._- ").find(c) != std::string_view::npos; }

/// Where the number that ends at `end` begins; `end` where there is none.
std::size_t beginOfNumber(const std::string& name, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && isDigit(name[begin - 1]) && end - begin < kMostFrameDigits) --begin;
  return begin;
}

}  // namespace

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return c < 0x80 ? char(std::tolower(c)) : char(c); });
  return text;
}

NumberedName splitName(const std::string& name) {
  const std::size_t extension = name.rfind('.') == std::string::npos ? name.size() : name.rfind('.');
  std::size_t begin = beginOfNumber(name, extension);
  if (begin < extension) return splitAt(name, begin, extension);
  for (std::size_t end = extension; end > 0; --end) {
    if (!isSeparator(name[end]) || end == extension) continue;
    begin = beginOfNumber(name, end);
    if (begin < end && (begin == 0 || isSeparator(name[begin - 1]))) return splitAt(name, begin, end);
  }
  return {name.substr(0, extension), name.substr(extension), 0, 0};
}

std::string keyOf(const std::string& prefix, const std::string& suffix, bool numbered) {
  const std::size_t extension = suffix.rfind('.') == std::string::npos ? suffix.size() : suffix.rfind('.');
  return prefix + (numbered ? "/" : "//") + suffix.substr(0, extension) + lowerCase(suffix.substr(extension));
}

}  // namespace quell::io
