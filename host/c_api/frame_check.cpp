// Checks of frames in the C API.
#include "host/c_api/boundary.hpp"
#include "host/c_api/frame.hpp"
#include "host/c_api/handles.hpp"

using namespace quell::c_api;

extern "C" {

const char* quellSeverityName(quell_severity severity) {
  if (severity < QUELL_NOTE || severity > QUELL_WRONG) return "unknown";
  return quell::toString(static_cast<quell::Severity>(severity));
}

quell_status quellCheckFrame(quell_denoiser* denoiser, const quell_frame* frame, cl_uint waitCount,
                             const cl_event* waitList, quell_frame_check* check) {
  return guarded("quellCheckFrame", [&] {
    require(denoiser, "quellCheckFrame", "denoiser");
    denoiser->check = {};
    denoiser->check = denoiser->denoiser.checkFrame(toFrame(frame, "quellCheckFrame"),
                                                    toEvents(waitCount, waitList, "quellCheckFrame"));
    const quell::FrameCheck& now = denoiser->check;
    denoiser->sentences.clear();
    for (const quell::Finding& finding : now.findings)
      denoiser->sentences.push_back(quell::toSentence(finding));
    if (check != nullptr)
      writeStruct(check,
                  {0, static_cast<quell_severity>(now.worst()), now.findings.size(), now.figures.size()},
                  "quellCheckFrame", "check");
  });
}

quell_status quellGetFinding(const quell_denoiser* denoiser, size_t index, quell_finding* finding) {
  return guarded("quellGetFinding", [&] {
    require(denoiser, "quellGetFinding", "denoiser");
    requireIndex(index, denoiser->check.findings.size(), "quellGetFinding", "index");
    const quell::Finding& found = denoiser->check.findings[index];
    writeStruct(finding,
                {0, static_cast<quell_severity>(found.severity), found.kind.c_str(), found.image.c_str(),
                 found.expected.c_str(), found.got.c_str(), found.cure.c_str(),
                 denoiser->sentences[index].c_str(), found.pixels},
                "quellGetFinding", "finding");
  });
}

quell_status quellGetCheckFigure(const quell_denoiser* denoiser, size_t index, quell_check_figure* figure) {
  return guarded("quellGetCheckFigure", [&] {
    require(denoiser, "quellGetCheckFigure", "denoiser");
    requireIndex(index, denoiser->check.figures.size(), "quellGetCheckFigure", "index");
    const quell::CheckFigure& measured = denoiser->check.figures[index];
    writeStruct(figure, {0, measured.name.c_str(), measured.unit.c_str(), measured.value},
                "quellGetCheckFigure", "figure");
  });
}

}  // extern "C"
