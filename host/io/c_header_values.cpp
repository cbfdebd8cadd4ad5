#include "host/io/c_header_values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "host/io/file_error.hpp"

namespace quell::io {
namespace {

/// How much of the offending text an error shows, in characters.
constexpr std::size_t kExcerptLength = 24;

bool isSpace(char c) { return std::strchr(" \t\r\n\v\f", c) != nullptr && c != '\0'; }
bool isWord(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Comments become one space, as in C.
std::string withoutComments(const std::string& text) {
  std::string result;
  std::size_t position = 0;
  while (position < text.size()) {
    const bool isLine = text.compare(position, 2, "//") == 0;
    if (!isLine && text.compare(position, 2, "/*") != 0) {
      result += text[position++];
      continue;
    }
    const std::size_t end = isLine ? text.find('\n', position) : text.find("*/", position + 2);
    if (end == std::string::npos) break;
    position = isLine ? end : end + 2;
    result += ' ';
  }
  return result;
}

}  // namespace

CHeaderValues::CHeaderValues(const std::string& text, std::string path)
    : m_text(withoutComments(text)), m_path(std::move(path)) {}

std::optional<std::size_t> CHeaderValues::endOf(const std::string& name) const {
  for (std::size_t at = m_text.find(name); at != std::string::npos; at = m_text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool isWhole =
        (at == 0 || !isWord(m_text[at - 1])) && (end == m_text.size() || !isWord(m_text[end]));
    if (isWhole) return end;
  }
  return std::nullopt;
}

std::size_t CHeaderValues::skipSpace(std::size_t position) const {
  while (position < m_text.size() && isSpace(m_text[position])) ++position;
  return position;
}

void CHeaderValues::refuse(const std::string& name, const std::string& expected, std::size_t position) const {
  const std::string rest = m_text.substr(std::min(position, m_text.size()), kExcerptLength);
  throwFileError("read C header", m_path, name + " followed by " + expected,
                 rest.empty() ? "the end of the file" : "\"" + rest + "\"");
}

/// Locale-independent; from_chars knows no leading plus, C does.
double CHeaderValues::parseNumber(const std::string& name, std::size_t& position) const {
  const std::size_t begin = position;
  if (position < m_text.size() && m_text[position] == '+') ++position;
  double value = 0.0;
  const char* end = m_text.data() + m_text.size();
  const auto parsed = std::from_chars(m_text.data() + position, end, value);
  if (parsed.ec != std::errc() || !std::isfinite(value)) refuse(name, "a finite number", begin);
  position = std::size_t(parsed.ptr - m_text.data());
  while (position < m_text.size() && std::strchr("fFlLuU", m_text[position]) != nullptr) ++position;
  if (position < m_text.size() && isWord(m_text[position])) refuse(name, "a finite number", begin);
  return value;
}

double CHeaderValues::parseItem(const std::string& name, std::size_t& position) const {
  const double value = parseNumber(name, position);
  const std::size_t next = skipSpace(position);
  if (next < m_text.size() && m_text[next] != ',' && m_text[next] != '}')
    refuse(name, "a comma or brace", next);
  return value;
}

std::optional<double> CHeaderValues::constant(const std::string& name) const {
  const auto end = endOf(name);
  if (!end) return std::nullopt;
  std::size_t position = skipSpace(*end);
  if (position < m_text.size() && m_text[position] == '=') position = skipSpace(position + 1);
  const bool isInParentheses = position < m_text.size() && m_text[position] == '(';
  if (isInParentheses) position = skipSpace(position + 1);
  return parseNumber(name, position);
}

std::optional<std::vector<double>> CHeaderValues::array(const std::string& name) const {
  const auto end = endOf(name);
  if (!end) return std::nullopt;
  const std::size_t equals = m_text.find_first_of("=;", *end);
  std::size_t position = equals == std::string::npos ? m_text.size() : skipSpace(equals + 1);
  if (position >= m_text.size() || m_text[position] != '{') refuse(name, "an initialiser in braces", *end);

  std::vector<double> values;
  int depth = 0;
  do {
    if (position >= m_text.size()) refuse(name, "closing braces", position);
    const char c = m_text[position];
    if (c == '{' || c == '}') depth += c == '{' ? 1 : -1;
    if (c == '{' || c == '}' || c == ',')
      ++position;
    else
      values.push_back(parseItem(name, position));
    position = skipSpace(position);
  } while (depth > 0);
  return values;
}

}  // namespace quell::io
