// Tables for terminals and for Markdown.
#pragma once

#include <string>
#include <vector>

namespace quell::cli {

/// Every row has as many cells as the header; cells have no line breaks.
struct TextTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Lines of aligned columns, two spaces between them; the first column stands left, the others right. Widths count
/// bytes.
std::string toText(const TextTable& table);

/// A Markdown table with the same alignment.
std::string toMarkdown(const TextTable& table);

}  // namespace quell::cli
