// Progress of a command, and warnings, on standard error.
#pragma once

#include <cstddef>
#include <string>

namespace quell::cli {

/// One line, over the bar that may be there: "quell: warning: FILE: expected EXPECTED, got GOT; REMEDY".
void warn(const std::string& file, const std::string& expected, const std::string& got,
          const std::string& remedy);

/// A bar on a terminal, plain lines otherwise.
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

/// A bar on a terminal, nothing otherwise; for work whose pieces differ in size.
class ShareProgress {
 public:
  /// `label` starts the line.
  explicit ShareProgress(std::string label);
  ~ShareProgress();

  /// `share` of all work is done, in [0, 1]; `detail` says what was done last.
  void show(double share, const std::string& detail);

 private:
  std::string m_label;
  bool m_terminal;
  bool m_shown = false;
};

}  // namespace quell::cli
