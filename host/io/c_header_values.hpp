// Numbers out of a C header, read as text: enough for data that ships as constant arrays, no preprocessor.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace quell::io {

/// Finds initialisers by name in the text of a header. Comments are ignored; numbers may carry f, l or u
/// suffixes; expressions and macros are not evaluated.
class CHeaderValues {
 public:
  /// `path` names the file in errors.
  CHeaderValues(const std::string& text, std::string path);

  /// The value of `NAME = 1.0f` or `#define NAME 1.0f`; nothing if the name does not occur.
  /// Throws Error(FileError) if something else than one finite number follows.
  std::optional<double> constant(const std::string& name) const;

  /// All numbers of `NAME[..]... = { {..}, ..}` in the order written, however the braces nest; nothing if the
  /// name does not occur. Throws Error(FileError): braces do not close, or something is not a finite number.
  std::optional<std::vector<double>> array(const std::string& name) const;

 private:
  std::optional<std::size_t> endOf(const std::string& name) const;
  std::size_t skipSpace(std::size_t position) const;
  double parseNumber(const std::string& name, std::size_t& position) const;
  double parseItem(const std::string& name, std::size_t& position) const;
  [[noreturn]] void refuse(const std::string& name, const std::string& expected, std::size_t position) const;

  std::string m_text;  // without comments
  std::string m_path;
};

}  // namespace quell::io
