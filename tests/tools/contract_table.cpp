// quell_contract_table README [--write]: checks, or writes, the table of images between the two markers of a Markdown
// file. It is made of the schema of images (quell/frame_images.h).
#include <fmt/format.h>

#include <cstdio>
#include <quell/error.hpp>
#include <quell/frame.hpp>
#include <string>

#include "host/core/image_schema.hpp"
#include "host/io/atomic_file.hpp"

namespace {

constexpr char kBegin[] = "<!-- images: made by quell_contract_table -->\n";
constexpr char kEnd[] = "<!-- end of images -->\n";

std::string rowOf(const std::string& name, const quell::ImageFacts& image) {
  const std::string channels = image.leastChannels == image.mostChannels
                                   ? std::to_string(image.leastChannels)
                                   : fmt::format("{} .. {}", image.leastChannels, image.mostChannels);
  const std::string required = image.required() ? "required" : image.texts.absent;
  return fmt::format("| {} | {} | {} | {} | {} | {} |\n", name, channels, required, image.texts.unit,
                     image.texts.range, image.texts.broken);
}

std::string makeTable() {
  std::string table =
      "| image | channels | without it | space and unit | range | NaN, Inf |\n|---|---|---|---|---|---|\n";
  for (const auto& image : quell::kInputs<quell::Frame>)
    table += rowOf(fmt::format("`{}`", image.name), image);
  for (const auto& image : quell::kOutputs<quell::Output>)
    table += rowOf(fmt::format("output `{}`", image.name), image);
  return table;
}

int run(const std::string& path, bool write) {
  const std::string before = quell::io::readFile(path);
  const std::size_t begin = before.find(kBegin), end = before.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin) {
    std::fprintf(stderr, "%s: no markers of the table\n", path.c_str());
    return 1;
  }
  const std::size_t first = begin + sizeof(kBegin) - 1;
  const std::string table = makeTable();
  if (before.compare(first, end - first, table) == 0) return 0;
  if (write) {
    quell::io::writeTextFile(path, before.substr(0, first) + table + before.substr(end));
    return 0;
  }
  std::fprintf(stderr,
               "%s differs from the schema of images; write it by quell_contract_table %s --write\n%s",
               path.c_str(), path.c_str(), table.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const bool write = argc == 3 && std::string(argv[2]) == "--write";
  if (argc != 2 && !write) {
    std::fprintf(stderr, "usage: quell_contract_table README [--write]\n");
    return 2;
  }
  try {
    return run(argv[1], write);
  } catch (const quell::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
