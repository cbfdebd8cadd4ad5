// The quell tool in tests: its command line as a function, and what it writes.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/cli/run_tool.hpp"
#include "host/io/atomic_file.hpp"

namespace quell::tests {

/// The sequence that ships with the repository: 12 frames of 240x135, from 4 to 15.
inline const std::string kData = std::string(QUELL_DATA_DIR) + "/colonnade";

/// Exit code of the tool.
inline int quell(const std::vector<std::string>& arguments) {
  std::vector<const char*> argv = {"quell"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return cli::runTool(static_cast<int>(argv.size()), argv.data());
}

/// What a command that ends with this code prints to the error stream, by way of this file.
inline std::string errorStreamOf(const std::vector<std::string>& arguments, int expectedCode,
                                 const std::string& file) {
  std::fflush(stderr);
  const int before = dup(STDERR_FILENO);
  const int text = open(file.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
  dup2(text, STDERR_FILENO);
  const int code = quell(arguments);
  std::fflush(stderr);
  dup2(before, STDERR_FILENO);
  close(text);
  close(before);
  CHECK(code == expectedCode);
  return io::readFile(file);
}

inline nlohmann::json readJson(const std::string& file) { return nlohmann::json::parse(io::readFile(file)); }

}  // namespace quell::tests
