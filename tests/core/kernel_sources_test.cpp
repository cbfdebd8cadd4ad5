// Kernels as they are embedded in the library.
#include "host/core/kernel_sources.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace quell::tests {
namespace {

std::vector<std::string> linesOf(std::istream& stream) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> fileLines(const std::string& name) {
  std::ifstream file(std::string(QUELL_KERNEL_DIR) + "/" + name);
  if (!file) file.open(std::string(QUELL_KERNEL_DIR) + "/../include/" + name);  // a public header
  INFO(name);
  REQUIRE(file);
  return linesOf(file);
}

}  // namespace

TEST_CASE("every kernel file is embedded under its stem", "[core]") {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(QUELL_KERNEL_DIR)) {
    if (entry.path().extension() != ".cl") continue;
    ++files;
    INFO(entry.path());
    REQUIRE(kernelSources().count(entry.path().stem().string()) == 1);
    const std::string& source = kernelSources().at(entry.path().stem().string());
    CHECK(source.find("#line 1 \"" + entry.path().filename().string() + "\"\n") == 0);
    CHECK(source.find("#include \"") == std::string::npos);
    CHECK(source.find(" " + entry.path().stem().string() + "(") != std::string::npos);
  }
  CHECK(files > 0);
  CHECK(kernelSources().size() == files);
}

TEST_CASE("line marks name the true file and line of everything embedded", "[core]") {
  for (const auto& [stem, source] : kernelSources()) {
    std::istringstream stream(source);
    std::vector<std::string> file;
    std::string name;
    std::size_t number = 0, compared = 0;
    for (const std::string& line : linesOf(stream)) {
      if (line.rfind("#line ", 0) == 0) {
        std::istringstream mark(line.substr(6));
        mark >> number;
        name = line.substr(line.find('"') + 1);
        name.pop_back();
        file = fileLines(name);
        continue;
      }
      INFO(stem << ": " << name << ":" << number);
      if (number <= file.size()) {
        REQUIRE(line == file[number - 1]);
        ++compared;
      } else {
        REQUIRE(line.empty());  // between the end of one file and the mark of the next
      }
      ++number;
    }
    CHECK(compared > file.size() / 2);
  }
}

}  // namespace quell::tests
