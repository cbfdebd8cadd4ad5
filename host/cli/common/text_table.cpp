#include "host/cli/common/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace quell::cli {
namespace {

std::vector<std::size_t> columnWidths(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    widths.push_back(table.header[i].size());
    for (const auto& row : table.rows) widths.back() = std::max(widths.back(), row[i].size());
  }
  return widths;
}

std::string textLine(const std::vector<std::string>& row, const std::vector<std::size_t>& widths) {
  std::string line = fmt::format("{:<{}}", row.front(), widths.front());
  for (std::size_t i = 1; i < row.size(); ++i) line += fmt::format("  {:>{}}", row[i], widths[i]);
  return line + "\n";
}

// A bar would end the cell.
std::string markdownCell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
  return cell;
}

std::string markdownLine(const std::vector<std::string>& row) {
  std::string line = "|";
  for (const std::string& text : row) line += " " + markdownCell(text) + " |";
  return line + "\n";
}

}  // namespace

std::string toText(const TextTable& table) {
  const std::vector<std::size_t> widths = columnWidths(table);
  std::string text = textLine(table.header, widths);
  for (const auto& row : table.rows) text += textLine(row, widths);
  return text;
}

std::string toMarkdown(const TextTable& table) {
  std::string text = markdownLine(table.header) + "|---|";
  for (std::size_t i = 1; i < table.header.size(); ++i) text += "---:|";
  text += "\n";
  for (const auto& row : table.rows) text += markdownLine(row);
  return text;
}

}  // namespace quell::cli
