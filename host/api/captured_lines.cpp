#include "host/api/captured_lines.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <limits>
#include <quell/error.hpp>
#include <utility>

#include "host/core/fnv1a.hpp"
#include "host/core/number_text.hpp"

namespace quell {
namespace {

constexpr char kEnd[] = "end ";
constexpr std::size_t kDigits = 16;  // of a checksum

std::string lastLine(const std::string& text) {
  return kEnd + hashText(fnv1a(text.data(), text.size())) + "\n";
}

}  // namespace

std::string hashText(std::uint64_t hash) {
  char text[kDigits + 1];
  std::snprintf(text, sizeof(text), "%016" PRIx64, hash);
  return text;
}

void LineWriter::put(double value) { putWord(numberText(value)); }

std::string LineWriter::finish() const { return m_text + lastLine(m_text); }

LineReader::LineReader(std::string path, const std::vector<unsigned char>& bytes) : m_path(std::move(path)) {
  constexpr std::size_t kMostText = 1 << 22;
  const std::string head(
      bytes.begin(),
      bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() < kMostText ? bytes.size() : kMostText));
  const std::size_t place = head.find(std::string("\n") + kEnd);
  m_size = place + 1 + sizeof(kEnd) - 1 + kDigits + 1;
  if (place == std::string::npos || head.size() < m_size)
    refuse("lines of text with a checksum", bytes.empty() ? "an empty file" : "a file that has none");
  m_text = head.substr(0, place + 1);
  m_lines = static_cast<std::size_t>(std::count(m_text.begin(), m_text.end(), '\n'));
  if (head.substr(place + 1, m_size - place - 1) != lastLine(m_text))
    refuse("lines as they were written", "others: the checksum differs");
}

void LineReader::refuse(const std::string& expected, const std::string& got) const {
  throw Error(ErrorCode::FileError, {"replay", m_path, expected, got});
}

void LineReader::readContents(const std::vector<unsigned char>& bytes) const {
  std::size_t place = m_size;
  for (const Block& block : m_blocks) {
    if (block.bytes > bytes.size() - place)
      refuse(std::to_string(block.bytes) + " bytes of an image from byte " + std::to_string(place) + " on",
             std::to_string(bytes.size() - place));
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(place);
    block.content->assign(begin, begin + static_cast<std::ptrdiff_t>(block.bytes));
    place += static_cast<std::size_t>(block.bytes);
    if (fnv1a(block.content->data(), block.content->size()) != block.hash.value)
      refuse("the bytes that were written", "others: the checksum of a content differs");
  }
  if (place != bytes.size())
    refuse("a file of " + std::to_string(place) + " bytes", std::to_string(bytes.size()));
}

bool LineReader::nextIs(const std::string& word) const {
  return m_text.compare(m_next, word.size() + 1, word + " ") == 0;
}

void LineReader::begin(const char* word) {
  const std::size_t end = m_text.find('\n', m_next);
  m_line = end == std::string::npos ? "" : m_text.substr(m_next, end - m_next);
  m_next = end == std::string::npos ? m_text.size() : end + 1;
  const std::string found = m_line.substr(0, m_line.find(' '));
  if (found != word) refuse(std::string("a line ") + word, found.empty() ? "the end" : "a line " + found);
  m_line.erase(0, found.size());
}

void LineReader::end() const {
  if (!m_line.empty()) refuse("the end of a line", m_line);
}

std::string LineReader::word() {
  if (m_line.empty()) refuse("a value", "the end of its line");
  const std::size_t end = m_line.find(' ', 1);
  const std::string found = m_line.substr(1, end == std::string::npos ? end : end - 1);
  m_line.erase(0, end == std::string::npos ? m_line.size() : end);
  return found;
}

void LineReader::text(const char* word, std::string& value) {
  begin(word);
  value = m_line.empty() ? "" : m_line.substr(1);
}

std::int64_t LineReader::whole(std::int64_t least, std::int64_t most) {
  const std::string found = word();
  std::int64_t value = 0;
  try {
    std::size_t used = 0;
    value = std::stoll(found, &used);
    if (used == found.size() && value >= least && value <= most) return value;
  } catch (const std::logic_error&) {
    // No number, or too large a one.
  }
  refuse("a whole number", found);
}

void LineReader::get(Hash& hash) {
  const std::string found = word();
  if (found.size() != kDigits || found.find_first_not_of("0123456789abcdef") != std::string::npos)
    refuse("16 hexadecimal digits", found);
  hash.value = std::stoull(found, nullptr, 16);
}

void LineReader::get(std::uint64_t& value) {
  value = static_cast<std::uint64_t>(whole(0, std::numeric_limits<std::int64_t>::max()));
}

void LineReader::get(double& value) {
  const std::string found = word();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (found == "inf" || found == "-inf") {
    value = found == "inf" ? kInfinity : -kInfinity;
  } else if (found == "nan") {
    value = std::numeric_limits<double>::quiet_NaN();
  } else if (!parseNumber(found, value)) {
    refuse("a number", found);
  }
}

}  // namespace quell
