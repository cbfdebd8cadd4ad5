// Progress of a command: a bar on a terminal, plain lines otherwise.
#pragma once

#include <cstddef>
#include <string>

namespace quell::cli {

class Progress {
 public:
  /// `label` starts the line; `total` steps, >= 1. Writes to standard error.
  Progress(std::string label, std::size_t total);
  ~Progress();

  /// Call after each step; `detail` says which it was.
  void step(const std::string& detail);

 private:
  std::string m_label;
  std::size_t m_total;
  std::size_t m_done = 0;
  bool m_terminal;
};

}  // namespace quell::cli
