#include "host/cli/check/report.hpp"

#include <fmt/format.h>

#include "host/cli/common/figures.hpp"

namespace quell::cli {
namespace {

/// Room for the longest name of a figure.
constexpr std::size_t kNameColumns = 64;

std::string figureText(const SequenceFigure& figure) {
  const std::string range =
      figure.frames > 1 ? fmt::format("  ({:.2f} to {:.2f})", figure.least, figure.most) : std::string();
  return fmt::format("  {:<{}} {:>9.2f} {}{}\n", figure.figure.name, kNameColumns, figure.figure.value,
                     figure.figure.unit, range);
}

std::string findingText(const SequenceFinding& found) {
  const Finding& finding = found.finding;
  return fmt::format("{}: {} ({})\n  {}\n  expected {}\n  got {}\n  {}\n", toString(finding.severity),
                     finding.kind, framesText(found.frames), found.file, finding.expected, gotText(finding),
                     finding.cure);
}

}  // namespace

std::string framesText(const std::vector<int>& frames) {
  return frames.size() == 1
             ? fmt::format("frame {}", frames.front())
             : fmt::format("{} frames from {} to {}", frames.size(), frames.front(), frames.back());
}

const char* verdictOf(Severity worst) { return worst == Severity::Note ? "fine" : toString(worst); }

int exitCodeOf(Severity worst) { return static_cast<int>(worst); }

std::string checkText(const std::string& name, const SequenceCheck& check) {
  std::string text = fmt::format("{}: {}\n", name, framesText(check.frames));
  for (const SequenceFigure& figure : check.figures) text += figureText(figure);
  for (const SequenceFinding& found : check.findings) text += "\n" + findingText(found);
  return text + fmt::format("\n{}\n", verdictOf(check.worst()));
}

nlohmann::ordered_json checkJson(const std::string& name, const SequenceCheck& check) {
  using Json = nlohmann::ordered_json;
  Json figures = Json::array(), findings = Json::array();
  for (const SequenceFigure& figure : check.figures)
    figures.push_back({{"name", figure.figure.name},
                       {"unit", figure.figure.unit},
                       {"mean", number<Json>(figure.figure.value)},
                       {"least", number<Json>(figure.least)},
                       {"most", number<Json>(figure.most)}});
  for (const SequenceFinding& found : check.findings) {
    const Finding& finding = found.finding;
    findings.push_back({{"kind", finding.kind},
                        {"severity", toString(finding.severity)},
                        {"image", finding.image},
                        {"file", found.file},
                        {"frames", found.frames},
                        {"expected", finding.expected},
                        {"got", finding.got},
                        {"pixels", finding.pixels},
                        {"cure", finding.cure}});
  }
  return {{"sequence", name},
          {"verdict", verdictOf(check.worst())},
          {"frames", check.frames},
          {"figures", figures},
          {"findings", findings}};
}

}  // namespace quell::cli
