#include <algorithm>
#include <quell/check.hpp>

namespace quell {

const char* toString(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Doubtful:
      return "doubtful";
    case Severity::Wrong:
      break;
  }
  return "wrong";
}

Severity FrameCheck::worst() const {
  Severity worst = Severity::Note;
  for (const Finding& finding : findings) worst = std::max(worst, finding.severity);
  return worst;
}

std::string gotText(const Finding& finding) {
  return finding.pixels == 0 ? finding.got : finding.got + " (" + std::to_string(finding.pixels) + " pixels)";
}

std::string toSentence(const Finding& finding) {
  return finding.image + ": expected " + finding.expected + ", got " + gotText(finding) + "; " + finding.cure;
}

}  // namespace quell
