#include "host/cli/check/sequence_check.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "host/check/checks.hpp"
#include "host/check/reference_checks.hpp"
#include "host/cli/common/frame_views.hpp"

namespace quell::cli {
namespace {

void addFigure(std::vector<SequenceFigure>& figures, const CheckFigure& figure) {
  const auto known = std::find_if(figures.begin(), figures.end(), [&](const SequenceFigure& other) {
    return other.figure.name == figure.name;
  });
  if (known == figures.end()) {
    figures.push_back({figure, figure.value, figure.value, 1});
    return;
  }
  known->figure.value += (figure.value - known->figure.value) / ++known->frames;
  known->least = std::min(known->least, figure.value);
  known->most = std::max(known->most, figure.value);
}

void addFinding(SequenceCheck& all, const Finding& finding, const std::string& file, int frame) {
  const auto known =
      std::find_if(all.findings.begin(), all.findings.end(), [&](const SequenceFinding& other) {
        return other.finding.kind == finding.kind && other.finding.image == finding.image;
      });
  if (known == all.findings.end()) {
    all.findings.push_back({finding, file, {frame}});
    return;
  }
  known->finding.severity = std::max(known->finding.severity, finding.severity);
  if (known->frames.back() != frame) known->frames.push_back(frame);
}

const char* imageOf(const io::FrameWarning& warning) {
  using Kind = io::FrameWarning::Kind;
  return warning.kind == Kind::Camera || warning.kind == Kind::CameraConvention ? "camera" : "radiance";
}

check::Result checkOne(const io::FrameSequence& sequence, const io::FrameData& frame,
                       const std::optional<io::FrameData>& before) {
  const check::Frame now = viewOf(frame);
  check::Frame last;
  if (before) last = viewOf(*before);
  check::Result result = check::checkFrame(now, before ? &last : nullptr);
  for (const io::FrameWarning& warning : frame.warnings)
    result.add({kindOf(warning), Severity::Doubtful, imageOf(warning), warning.expected, warning.got,
                warning.remedy, 0});
  for (const auto kind : {io::ReferenceKind::Centre, io::ReferenceKind::Antialiased}) {
    if (!sequence.hasReference(frame.number, kind) || !frame.comparable()) continue;
    const io::Reference reference = sequence.reference(frame.number, kind);
    for (Finding& finding :
         check::checkReference(viewOf(frame.noisy()), viewOf(reference.a), viewOf(reference.b)))
      result.add(std::move(finding));
  }
  return result;
}

}  // namespace

Severity SequenceCheck::worst() const {
  return findings.empty() ? Severity::Note : findings.front().finding.severity;
}

SequenceCheck checkSequence(const io::FrameSequence& sequence, const std::vector<int>& frames,
                            const FindingSink& sink) {
  SequenceCheck all;
  std::optional<io::FrameData> before;
  for (const int number : frames) {
    io::FrameData frame = sequence.read(number);
    const check::Result result = checkOne(sequence, frame, before);
    all.frames.push_back(number);
    for (const CheckFigure& figure : result.figures) addFigure(all.figures, figure);
    for (const check::MappedFinding& found : result.findings) {
      addFinding(all, found.finding, fileOfImage(sequence, number, found.finding.image), number);
      if (sink) sink(frame, found);
    }
    before = std::move(frame);
  }
  std::stable_sort(all.findings.begin(), all.findings.end(),
                   [](const SequenceFinding& a, const SequenceFinding& b) {
                     return a.finding.severity > b.finding.severity;
                   });
  return all;
}

}  // namespace quell::cli
