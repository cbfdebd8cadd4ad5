#include "host/cli/common/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace quell::cli {
namespace {

constexpr std::size_t kBarColumns = 40;
constexpr char kClearLine[] = "\r\033[K";

bool isTerminal() { return isatty(STDERR_FILENO) == 1; }

/// Over the line that is there.
void drawBar(const std::string& label, double share, const std::string& figures) {
  const std::size_t filled = static_cast<std::size_t>(share * kBarColumns + 1e-9);
  fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {} ", label, "", filled, "", kBarColumns - filled, figures);
}

}  // namespace

void warn(const std::string& file, const std::string& expected, const std::string& got,
          const std::string& remedy) {
  fmt::print(stderr, "{}quell: warning: {}: expected {}, got {}; {}\n", isTerminal() ? kClearLine : "", file,
             expected, got, remedy);
  std::fflush(stderr);
}

Progress::Progress(std::string label, std::size_t total)
    : m_label(std::move(label)), m_total(total), m_terminal(isTerminal()) {}

Progress::~Progress() {
  if (m_terminal && m_done > 0) fmt::print(stderr, "\n");
}

void Progress::step(const std::string& detail) {
  ++m_done;
  if (m_terminal) {
    drawBar(m_label, static_cast<double>(m_done) / static_cast<double>(m_total),
            fmt::format("{}/{} {}", m_done, m_total, detail));
  } else {
    fmt::print(stderr, "{} {}/{} {}\n", m_label, m_done, m_total, detail);
  }
  std::fflush(stderr);
}

ShareProgress::ShareProgress(std::string label) : m_label(std::move(label)), m_terminal(isTerminal()) {}

ShareProgress::~ShareProgress() {
  if (m_shown) fmt::print(stderr, "\n");
}

void ShareProgress::show(double share, const std::string& detail) {
  if (!m_terminal) return;
  drawBar(m_label, std::clamp(share, 0.0, 1.0), fmt::format("{:3.0f} % {:<28}", 100.0 * share, detail));
  std::fflush(stderr);
  m_shown = true;
}

}  // namespace quell::cli
