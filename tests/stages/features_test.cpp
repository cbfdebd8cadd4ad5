// The stages of a fit with other features than the default ones, against the same oracles.
#include "tests/cases/blended_sum_case.hpp"
#include "tests/cases/fit_case.hpp"
#include "tests/cases/gram_solve_case.hpp"
#include "tests/cases/weighted_sum_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

// From the constant alone to the most there may be: unscaled, without the lower powers, roots and differences, the
// choice of Flatval 2020, table 5.4, and sixteen.
const char* const kLists[] = {"1",
                              "1,n",
                              "w2,gx",
                              "n,g,roughness",
                              "w,sqrt(w),w-w,depth,ar",
                              "w2,sqrt(nx),wx*ny,nx,nz,sqrt(ny),wx*wy",
                              "wx3,wx*wy*wz,roughness2,nx-ny,n2,sqrt(depth),depth2*ag",
                              "n,w,w2,albedo,roughness,g"};

// Positions are floats of up to 20 units; a difference or root of them has lost a digit or two when it is scaled.
constexpr double kFitListTolerance = 5e-5;

CaseOptions makeOptions(const char* list, Size size, Mapping mapping) {
  CaseOptions options;
  options.features = list;
  options.size = size;
  options.mapping = mapping;
  return options;
}

// The constant alone; roots and differences; powers and products.
bool isAmongFew(const char* list) { return list == kLists[0] || list == kLists[4] || list == kLists[6]; }

// Every list is a kernel of its own: a few run always, one of them on one lane, all of them in long tests.
enum class Lists { Few, All };

template <class Check>
void forEachList(Lists lists, const Check& check) {
  for (const char* list : kLists) {
    if (lists == Lists::Few && !isAmongFew(list)) continue;
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      if (mapping == Mapping::Narrow && (lists == Lists::All ? !isAmongFew(list) : list != kLists[4]))
        continue;
      for (const Size size : {Size{7, 33}, Size{61, 43}}) {
        INFO(list);
        check(makeOptions(list, size, mapping));
      }
    }
  }
}

void checkWithin(StageCase& stageCase, const CaseOptions& options, double tolerance) {
  const Comparison comparison = stageCase.check();
  INFO(describe(options) << ": " << comparison.worst());
  CHECK(comparison.compared() > 0);
  CHECK(comparison.largestError() <= tolerance);
}

void checkFit(const CaseOptions& options) {
  FitCase fit(options);
  checkWithin(fit, options, kFitListTolerance);
  CHECK(allFinite(fit.records()));
}

void checkGramSums(const GramWindows& windows, const CaseOptions& options) {
  GramSumsCase sums(options, windows);
  checkWithin(sums, options, 2.0 * kGramSumTolerance);
}

void checkGramSolve(const GramWindows& windows, const CaseOptions& options) {
  GramSolveCase solve(options, windows);
  checkWithin(solve, options, kGramSolveTolerance);
  const Comparison pixels = solve.comparePixels();
  INFO("straight from the pixels: " << pixels.worst());
  CHECK(pixels.largestError() <= kGramPixelsTolerance);
}

void checkSums(const CaseOptions& options) {
  WeightedSumCase weighted(options);
  checkWithin(weighted, options, kWeightedSumTolerance);
  BlendedSumCase blended(options);
  checkWithin(blended, options, kBlendedSumTolerance);
}

}  // namespace

TEST_CASE("fit agrees with its oracle for lists of features") { forEachList(Lists::Few, checkFit); }

TEST_CASE("fit with half storage agrees with its oracle for a list of features") {
  const CaseOptions options = makeOptions(kLists[4], {61, 43}, Mapping::Wide);
  FitCase fit(options, FeatureStorage::Half);
  checkWithin(fit, options, kFitHalfTolerance);
}

TEST_CASE("fit without noise leaves dependent features of a list out") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    // The differences and the depth are combinations of the positions.
    const CaseOptions options = makeOptions("w,w-w,depth", {61, 43}, mapping);
    FitCase fit(options, FeatureStorage::Float, 0.0);
    fit.uploadAndRun();
    CHECK(allFinite(fit.records()));
  }
}

// Windows decide which pixels are summed, a list what is summed of each: overlapping ones will do.
TEST_CASE("gram_sums agrees with its oracle for lists of features") {
  forEachList(Lists::Few, [](const CaseOptions& options) { checkGramSums(kOverlap8, options); });
}

TEST_CASE("gram_solve agrees with its oracle for lists of features") {
  forEachList(Lists::Few, [](const CaseOptions& options) { checkGramSolve(kOverlap8, options); });
}

TEST_CASE("weighted_sum and blended_sum agree with their oracles for lists of features") {
  forEachList(Lists::Few, checkSums);
}

TEST_CASE("all stages of the fit agree with their oracles for all lists of features", "[.long]") {
  forEachList(Lists::All, checkFit);
  forEachList(Lists::All, checkSums);
  forEachList(Lists::All, [](const CaseOptions& options) { checkGramSums(kOverlap8, options); });
  forEachList(Lists::All, [](const CaseOptions& options) { checkGramSolve(kOverlap8, options); });
  forEachList(Lists::Few, [](const CaseOptions& options) { checkGramSums(kBlocks, options); });
  forEachList(Lists::Few, [](const CaseOptions& options) { checkGramSolve(kBlocks, options); });
}

TEST_CASE("a list gives the same bits whatever the work-group and the number of lanes") {
  Planes first;
  for (const auto& [mapping, group] :
       {std::pair(Mapping::Wide, 1), std::pair(Mapping::Wide, 16), std::pair(Mapping::Narrow, 256)}) {
    CaseOptions options = makeOptions(kLists[4], {61, 43}, mapping);
    options.fitGroup = group;
    FitCase fit(options);
    fit.uploadAndRun();
    if (first.values.empty()) first = fit.records();
    INFO(describe(options));
    CHECK(sameBits(first, fit.records()));
  }
}
