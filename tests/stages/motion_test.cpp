// Motion vectors, object ids and jitter in the stage accumulate_noisy.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/cases/accumulate_noisy_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"
#include "tests/support/test_scene.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

const AccumulateNoisyVariant kPlain{kPlainMaterial};
const AccumulateNoisyVariant kMotion{kPlainMaterial, false, false, false, true, false};
const AccumulateNoisyVariant kObjects{kPlainMaterial, false, false, false, false, true};
const AccumulateNoisyVariant kMotionAndObjects{kPlainMaterial, false, false, false, true, true};

CaseMaker maker(const AccumulateNoisyVariant& variant) {
  return [variant](const CaseOptions& options) {
    return std::make_unique<AccumulateNoisyCase>(options, variant);
  };
}

TestCamera withJitter(TestCamera camera, double x, double y) {
  camera.jitterPx = {x, y};
  return camera;
}

// Now and before: a camera that moves, with another jitter in each frame.
const TestCamera kNow = withJitter({}, 0.4, -0.3);
const TestCamera kBefore = withJitter(movedCamera(), -0.25, 0.1);

void seeScene(AccumulateNoisyCase& noisy, const TestCamera& now, const TestCamera& before) {
  const SceneView view = renderScene(now, noisy.size());
  noisy.inputs.normal = view.normalWorld;
  noisy.inputs.position = noisy.inputs.positionIsDepth ? view.viewDepth : view.positionWorld;
  noisy.inputs.guidesPrev = renderScene(before, noisy.size()).guides;
  noisy.useReprojection(makeReprojection(now, before, noisy.size()));
}

bool isSurface(const Planes& guides, int x, int y) { return guides.at(QUELL_GUIDE_WEIGHT, x, y) > 0.0f; }

// Pixels that found history.
std::size_t accepted(const AccumulateNoisyCase& noisy) {
  std::size_t count = 0;
  for (const float mask : noisy.outputs().reprojectionMask.values) count += (int(mask) & 15) != 0;
  return count;
}

// The motion of all pixels.
void moveAll(AccumulateNoisyCase& noisy, float x, float y) {
  forEachPixel(noisy.size(), [&](int column, int row) {
    noisy.inputs.motion.at(column, row, 0) = x;
    noisy.inputs.motion.at(column, row, 1) = y;
  });
}

// Camera and scene at rest, every vector 0, every object where it was, history everywhere.
void rest(AccumulateNoisyCase& noisy) {
  seeScene(noisy, {}, {});
  if (!noisy.inputs.motion.empty()) moveAll(noisy, 0.0f, 0.0f);
  for (float& length : noisy.inputs.historyLengthPrev.values) length = 3.0f;
  if (noisy.inputs.objectId.empty()) return;
  forEachPixel(noisy.size(), [&](int x, int y) {
    noisy.inputs.objectIdsPrev.at(0, x, y) = noisy.inputs.objectId.at(x, y, 0);
  });
}

std::size_t acceptedAfter(AccumulateNoisyCase& noisy) {
  noisy.uploadAndRun();
  return accepted(noisy);
}

// Object ids of this frame and of the one before: of each object, of another object before, 0 or 1 everywhere.
enum class Ids { Each, Other, Zero, One };

// Pixels that find history where everything was far to the left in the frame before, beyond the limit of the position
// test, though at the same pixel; and nearer by so much. Surfaces are 4 to 7 units away: a tenth of that counts as near.
std::size_t acceptedOfMoved(const AccumulateNoisyVariant& variant, float nearer, Ids ids) {
  CaseOptions options;
  options.size = {61, 40};
  AccumulateNoisyCase noisy(options, variant);
  rest(noisy);
  if (ids == Ids::Zero || ids == Ids::One) noisy.giveAllObjects(ids == Ids::One ? 1.0f : 0.0f);
  if (ids == Ids::Other)
    for (float& id : noisy.inputs.objectIdsPrev.values) id += 1.0f;
  forEachPixel(noisy.size(), [&](int x, int y) {
    noisy.inputs.guidesPrev.at(QUELL_GUIDE_POSITION, x, y) -= 5.0f;
    noisy.inputs.guidesPrev.at(QUELL_GUIDE_POSITION + 2, x, y) += nearer;
  });
  return acceptedAfter(noisy);
}

}  // namespace

TEST_CASE("accumulate_noisy follows motion vectors and object ids as its oracle does") {
  checkSizes(maker(kMotionAndObjects));
}

TEST_CASE("accumulate_noisy agrees with its oracle with motion vectors or object ids alone") {
  checkVariants({maker(kMotion), maker(kObjects), maker({kTwoSignals, true, true, true, true, true})});
}

TEST_CASE("accumulate_noisy reads motion vectors and object ids in every layout") {
  checkLayouts(maker(kMotionAndObjects),
               {packed(2), packedHalf(3), interleaved(4, ComponentFormat::Float16)});
}

TEST_CASE("accumulate_noisy reads motion vectors and object ids in all further layouts", "[.long]") {
  checkLayouts(maker(kMotionAndObjects), inputLayouts());
}

TEST_CASE("accumulate_noisy with motion vectors does not depend on the work-group") {
  checkWorkGroups(maker(kMotionAndObjects),
                  {"irradiance", "historyLength", "guides", "objectIds", "pixelPrev", "reprojectionMask"});
}

TEST_CASE("accumulate_noisy finds by motion vectors what it finds by matrices, jitter included") {
  for (const CaseOptions& options : bothMappings({117, 80})) {
    AccumulateNoisyCase byMatrices(options, {kPlainMaterial}), byMotion(options, kMotion);
    seeScene(byMatrices, kNow, kBefore);
    seeScene(byMotion, kNow, kBefore);
    byMatrices.uploadAndRun();
    const Planes expected = byMatrices.outputs().pixelPrev;
    // What a pixel shows counts for its centre now and before, so vectors lead from pixel to pixel.
    forEachPixel(options.size, [&](int x, int y) {
      byMotion.inputs.motion.at(x, y, 0) = expected.at(0, x, y) - float(x);
      byMotion.inputs.motion.at(x, y, 1) = expected.at(1, x, y) - float(y);
    });
    byMotion.uploadAndRun();
    const auto found = byMotion.outputs(), wanted = byMatrices.outputs();
    std::size_t elsewhere = 0, inside = 0;
    forEachPixel(options.size, [&](int x, int y) {
      if (wanted.reprojectionMask.at(0, x, y) == 0.0f) return;
      ++inside;
      elsewhere += std::abs(found.pixelPrev.at(0, x, y) - expected.at(0, x, y)) > 1.0 / 256 ||
                   std::abs(found.pixelPrev.at(1, x, y) - expected.at(1, x, y)) > 1.0 / 256;
    });
    CHECK(inside > 8000);
    CHECK(elsewhere == 0);
    CHECK(100 * accepted(byMotion) > 98 * accepted(byMatrices));
  }
}

TEST_CASE("accumulate_noisy under jitter finds what stands still at its own pixel and keeps its history") {
  for (const bool viewDepth : {false, true}) {
    CaseOptions options;
    options.size = {117, 80};
    AccumulateNoisyCase noisy(options, {kPlainMaterial, viewDepth});
    seeScene(noisy, kNow, withJitter({}, -0.25, 0.1));
    noisy.uploadAndRun();
    const auto outputs = noisy.outputs();
    const Planes expected = renderScene(kNow, options.size).guides;
    const Planes& before = noisy.inputs.guidesPrev;
    std::size_t surfaces = 0, lost = 0;
    double worstPosition = 0.0;
    forEachPixel(options.size, [&](int x, int y) {
      if (!isSurface(outputs.guides, x, y) || outputs.reprojectionMask.at(0, x, y) == 0.0f) return;
      ++surfaces;
      CHECK(outputs.pixelPrev.at(0, x, y) == float(x));
      CHECK(outputs.pixelPrev.at(1, x, y) == float(y));
      // The samples of one surface in two frames may lie a pixel apart.
      const int z = QUELL_GUIDE_POSITION + 2;
      const bool same = std::abs(before.at(z, x, y) - expected.at(z, x, y)) < 0.01f;
      lost += same && (int(outputs.reprojectionMask.at(0, x, y)) & 1) == 0;
      for (int axis = 0; axis < 3; ++axis)
        worstPosition = std::max(worstPosition,
                                 std::abs(double(outputs.guides.at(axis, x, y)) - expected.at(axis, x, y)));
    });
    INFO((viewDepth ? "view depth" : "positions"));
    CHECK(surfaces > 6000);
    CHECK(lost == 0);
    CHECK(worstPosition < 1e-5);  // a hundredth of a footprint would be 2e-4
  }
}

TEST_CASE("an object that moved loses its history by matrices and keeps it by motion vectors") {
  const std::size_t all = acceptedOfMoved(kMotionAndObjects, 0.0f, Ids::Each);
  CHECK(all > 1000);
  CHECK(acceptedOfMoved(kMotion, 0.0f, Ids::Each) == all);
  CHECK(acceptedOfMoved(kPlain, 0.0f, Ids::Each) == 0);
  CHECK(acceptedOfMoved(kObjects, 0.0f, Ids::Each) == 0);
  CHECK(acceptedOfMoved(kMotionAndObjects, 0.0f, Ids::Other) == 0);
}

TEST_CASE("object ids only speak against a history sample") {
  const std::size_t all = acceptedOfMoved(kMotion, 0.38f, Ids::Each);
  CHECK(all > 1000);
  CHECK(acceptedOfMoved(kMotion, 0.72f, Ids::Each) == 0);
  for (const Ids ids : {Ids::Each, Ids::Zero, Ids::One}) {
    CHECK(acceptedOfMoved(kMotionAndObjects, 0.38f, ids) == all);
    CHECK(acceptedOfMoved(kMotionAndObjects, 0.72f, ids) == 0);
    CHECK(acceptedOfMoved(kObjects, 0.0f, ids) == 0);
  }
}

TEST_CASE("a surface that turns keeps its history while it turns slowly") {
  const auto acceptedAfterTurn = [](double radians) {
    CaseOptions options;
    options.size = {61, 40};
    AccumulateNoisyCase noisy(options, kMotionAndObjects);
    rest(noisy);
    const float c = float(std::cos(radians)), s = float(std::sin(radians));
    forEachPixel(noisy.size(), [&](int x, int y) {
      float& right = noisy.inputs.guidesPrev.at(QUELL_GUIDE_NORMAL, x, y);
      float& back = noisy.inputs.guidesPrev.at(QUELL_GUIDE_NORMAL + 2, x, y);
      const float turned = c * right + s * back;
      back = c * back - s * right;
      right = turned;
    });
    return acceptedAfter(noisy);
  };
  const std::size_t all = acceptedAfterTurn(0.0);
  // The limit, a squared difference of 0.1, is 18 degrees for normals across the axis.
  CHECK(acceptedAfterTurn(0.3) == all);
  CHECK(acceptedAfterTurn(0.5) == 0);
}

TEST_CASE("accumulate_noisy drops history along motion vectors that are broken or lead far away") {
  const float kInfinity = std::numeric_limits<float>::infinity();
  for (const CaseOptions& options : bothMappings({61, 40})) {
    AccumulateNoisyCase noisy(options, kMotion);
    rest(noisy);
    CHECK(acceptedAfter(noisy) > 1000);
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity, 1e30f, -3e38f, 62.0f}) {
      INFO(bad);
      for (const bool vertical : {false, true}) {
        moveAll(noisy, vertical ? 0.0f : bad, vertical ? bad : 0.0f);
        CHECK(acceptedAfter(noisy) == 0);
        const auto outputs = noisy.outputs();
        CHECK(allFinite(outputs.irradiance));
        CHECK(allFinite(outputs.pixelPrev));
      }
    }
  }
}
