#include <cmath>

#include "kernels/common/guides.h"
#include "tests/cases/virtual_motion_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

std::unique_ptr<StageCase> make(const CaseOptions& options) {
  return std::make_unique<VirtualMotionCase>(options);
}

}  // namespace

TEST_CASE("virtual_motion agrees with its oracle") { checkSizes(make); }

TEST_CASE("virtual_motion of parallel rays agrees with its oracle") {
  for (const CaseOptions& options : bothMappings()) {
    VirtualMotionCase parallel(options, true);
    checkAgreement(parallel, options);
  }
}

TEST_CASE("virtual_motion leaves out background") { checkHoles(make); }

TEST_CASE("virtual_motion does not depend on the work-group") {
  checkWorkGroups(make, {"virtualPositions", "virtualPixelPrev", "virtualMask"});
}

TEST_CASE("virtual_motion of unknown hit distances is that of the surface") {
  for (const CaseOptions& options : bothMappings()) {
    VirtualMotionCase unknown(options);
    for (float& hit : unknown.inputs.hitDistance.pixels) hit = std::nanf("");
    unknown.uploadAndRun();
    CHECK(sameBits(unknown.positions(), planesOf(unknown.inputs.guides, QUELL_GUIDE_POSITION, 3)));
    CHECK(sameBits(unknown.pixelPrev(), unknown.inputs.pixelPrev));
    CHECK(sameBits(unknown.mask(), planesOf(unknown.inputs.reprojectionMask, 1, 1)));
  }
}
