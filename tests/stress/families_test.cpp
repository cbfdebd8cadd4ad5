// Every family of random blocks against the bounds of its class, for the solver that is held to them.
#include <catch2/catch.hpp>

#include "tests/stress/test_fitter.hpp"

namespace quell::stress {
namespace {

constexpr std::uint64_t kBlocks = 384;
constexpr std::uint32_t kSeed = 20;

void checkFamilies(BlockFitter& fitter, std::uint64_t blocks) {
  for (const Family& family : families()) {
    const SolverFigures gram = runFamily(family, fitter, blocks, kSeed).gram;
    INFO(family.name << ": excess residual " << gram.worst.excessResidual << ", outside the range "
                     << gram.worst.outsideRange);
    CHECK(gram.blocks >= blocks);
    CHECK(gram.nonFinite == 0);
    CHECK(withinBounds(gram, family.posedness));
  }
}

}  // namespace

TEST_CASE("gram keeps the bounds of every family") { checkFamilies(sharedFitter(), kBlocks); }

TEST_CASE("gram keeps the bounds with one pixel a work-item") {
  FitterOptions options = testOptions();
  options.options.mapping = Mapping::Narrow;
  BlockFitter fitter(options);
  checkFamilies(fitter, 128);
}

TEST_CASE("a family's blocks depend on nothing but its name and the seed") {
  for (const Family& family : families()) {
    const Batch first = makeBatch(family, 3, 1, 2);
    const Batch second = makeBatch(family, 3, 1, 2);
    const Batch other = makeBatch(family, 4, 1, 2);
    INFO(family.name);
    CHECK(sameBits(first, second));
    CHECK((family.name == "zero colors" || !sameBits(first, other)));
  }
}

}  // namespace quell::stress
