#include "host/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace quell::cli {
namespace {

constexpr std::size_t kBarColumns = 40;

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : m_label(std::move(label)), m_total(total), m_terminal(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (m_terminal && m_done > 0) fmt::print(stderr, "\n");
}

void Progress::step(const std::string& detail) {
  ++m_done;
  if (m_terminal) {
    const std::size_t filled = kBarColumns * m_done / m_total;
    fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {}/{} {} ", m_label, "", filled, "", kBarColumns - filled,
               m_done, m_total, detail);
  } else {
    fmt::print(stderr, "{} {}/{} {}\n", m_label, m_done, m_total, detail);
  }
  std::fflush(stderr);
}

}  // namespace quell::cli
