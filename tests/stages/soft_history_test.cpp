#include "tests/cases/soft_history_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(int signal, bool motion = false) {
  return
      [=](const CaseOptions& options) { return std::make_unique<SoftHistoryCase>(options, signal, motion); };
}

// Nothing moved, every tap is accepted, long histories.
void standStill(SoftHistoryCase& history) {
  SoftHistoryInputs& inputs = history.inputs;
  forEachPixel(history.size(), [&](int x, int y) {
    inputs.pixelPrev.at(0, x, y) = float(x);
    inputs.pixelPrev.at(1, x, y) = float(y);
    inputs.tapMask.at(0, x, y) = QUELL_PREV_IN_FRAME | QUELL_TAP_ACCEPTED(0);
    inputs.historyLength.at(0, x, y) = QUELL_MAX_HISTORY_LENGTH;
  });
}

}  // namespace

TEST_CASE("soft_history agrees with its oracle") { checkSizes(maker(0)); }

TEST_CASE("soft_history of either signal and with motion vectors agrees with its oracle") {
  checkVariants({maker(1), maker(0, true), maker(1, true)});
}

TEST_CASE("soft_history leaves out background") {
  checkHoles(maker(0));
  checkHoles(maker(1));
}

TEST_CASE("soft_history does not depend on the work-group") {
  checkWorkGroups(maker(0), {"blended", "confidence"});
}

TEST_CASE("soft_history trusts what lies where it should, and nothing far away") {
  for (const CaseOptions& options : bothMappings()) {
    SoftHistoryCase history(options);
    standStill(history);
    const Planes positions = history.inputs.positions;
    for (const float away : {0.0f, 0.05f, 0.2f}) {
      // A footprint is .025 wide at this depth: three are near, six are far.
      history.inputs.positionsPrev = positions;
      const QuellFloat4 motion = history.inputs.reprojection.cameraMotion;
      forEachPixel(options.size, [&](int x, int y) {
        history.inputs.positionsPrev.at(0, x, y) += away - motion.x;
        history.inputs.positionsPrev.at(1, x, y) -= motion.y;
        history.inputs.positionsPrev.at(2, x, y) -= motion.z;
      });
      history.uploadAndRun();
      const float wanted = away < 0.1f ? 1.0f : 0.0f;
      for (const float found : history.confidence().values) CHECK(found == wanted);
    }
    // Without trust the newest sample is all there is.
    CHECK(sameBits(history.blended(), history.inputs.irradiance));
  }
}
