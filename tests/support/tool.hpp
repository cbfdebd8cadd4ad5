// The quell tool in tests: its command line as a function, and what it writes.
#pragma once

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

inline nlohmann::json readJson(const std::string& file) { return nlohmann::json::parse(io::readFile(file)); }

}  // namespace quell::tests
