// Kernels that are compiled as one program.
#include "host/core/program_groups.hpp"

#include <catch2/catch.hpp>
#include <memory>
#include <set>

#include "host/core/kernel_uses.hpp"
#include "host/methods/method.hpp"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

const std::string kFlags = "-cl-std=CL1.2 -D QUELL_LANES=1";
const KernelUse kSums{"change_sums", kFlags + " -D QUELL_SIGNALS=1"};
const KernelUse kWeight{"change_weight", kFlags + " -D QUELL_SIGNALS=1"};

KernelUse with(const KernelUse& use, const std::string& defines) { return {use.stem, use.options + defines}; }

std::size_t groupCount(const std::vector<KernelUse>& uses) { return groupKernels(uses).size(); }

/// What the method's stages compile on the tests' device for the images of a SmallDenoiser.
std::vector<KernelUse> usesOf(const std::string& method, const SmallDenoiser& small) {
  Configuration configuration{{}, {}, Settings(method), small.buffers.frame, small.buffers.output};
  configuration.options = testOptions();
  configuration.device = queryDeviceTraits(small.device.device, Mapping::Automatic);
  const Method& found = findMethod(method);
  configuration.runtime = found.runtimeSettings(configuration.settings);
  const Schedule schedule = found.makeSchedule(configuration);
  std::vector<KernelUse> uses;
  for (const StageRow& row : schedule)
    for (const KernelUse& use : kernelUses(*row.stage, configuration)) uses.push_back(use);
  return uses;
}

}  // namespace

TEST_CASE("kernels share a program where every option means the same to both", "[core]") {
  const std::vector<ProgramGroup> groups = groupKernels({kSums, kWeight, kSums});
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].kernels == std::vector<KernelUse>{kSums, kWeight});
  CHECK(groups[0].name() == "change_sums, change_weight");
  CHECK(groups[0].options() == kSums.options);
  CHECK(groups[0].source() == kernelSource("change_sums") + kernelSource("change_weight"));

  const auto further = groupKernels({kSums, with(kWeight, " -D FIRST=1 -D SECOND=f(1,-2)")});
  REQUIRE(further.size() == 1);
  CHECK(further[0].options() == kSums.options + " -D FIRST=1 -D SECOND=f(1,-2)");
}

TEST_CASE("kernels share no program where an option would change the other", "[core]") {
  CHECK(groupCount({kSums, {"change_weight", kFlags + " -D QUELL_SIGNALS=2"}}) == 2);
  CHECK(groupCount({kSums, {"change_weight", "-cl-std=CL2.0 -D QUELL_LANES=1 -D QUELL_SIGNALS=1"}}) == 2);
  CHECK(groupCount({kSums, with(kSums, " -D SKIP=1")}) == 2);  // one kernel function twice
  // The fit asks whether there is a list of features.
  const KernelUse fit{"fit", kFlags + " -D QUELL_SIGNALS=1"};
  CHECK(groupCount({fit, kSums}) == 1);
  CHECK(groupCount({fit, with(kSums, " -D QUELL_FEATURE_LIST=")}) == 2);
  // Layouts of images change more often than other options.
  CHECK(groupCount({with(kSums, " -D RADIANCE_FORMAT=1"), kWeight}) == 2);
}

TEST_CASE("what is held already stays out of the groups, and what nobody needs any more goes", "[core]") {
  const KernelUse follow = with({"follow_change", kFlags}, " -D QUELL_SIGNALS=1 -D SKIP=1");
  ProgramShelf shelf;
  const auto program = std::make_shared<const cl::Program>();
  shelf.put({{kSums}}, program);
  shelf.put({{follow}}, std::make_shared<const cl::Program>());
  shelf.expect({kSums, kWeight});
  CHECK(shelf.find(kSums) == program);
  CHECK(shelf.find(follow) == nullptr);
  CHECK(shelf.groupOf(kWeight).kernels == std::vector<KernelUse>{kWeight});
  CHECK(shelf.groupOf(follow).kernels == std::vector<KernelUse>{follow});  // not expected: alone
}

TEST_CASE("every method's groups compile as they are", "[core]") {
  const SmallDenoiser small;
  for (const std::string& method : methodNames()) {
    INFO(method);
    const TemporaryDirectory unique;
    ProgramCache::setSourceComment(unique.path());
    const int before = ProgramCache::counters().built;
    Denoiser denoiser(small.device.context, small.device.device, small.device.queue, Settings(method),
                      testOptions());
    denoiser.prepare(small.buffers.frame, small.buffers.output);
    ProgramCache::setSourceComment("");
    const std::vector<KernelUse> uses = usesOf(method, small);
    CHECK(ProgramCache::counters().built - before == static_cast<int>(groupCount(uses)));
    if (method == "quell")  // change_*, light_*, follow_change, variance and the first iteration in one
      CHECK(groupCount(uses) == std::set<KernelUse>(uses.begin(), uses.end()).size() - 6);
  }
}

TEST_CASE("kernels that the compiler takes only one by one are compiled so", "[core]") {
  const OpenDevice device;
  const ProgramCache cache("");
  Configuration configuration{{}, {}, Settings(), {}, {}};
  configuration.device = queryDeviceTraits(device.device, Mapping::Narrow);
  const std::string signals = " -D QUELL_SIGNALS=1";
  const std::string hurtsSums = signals + " -D emptySums=0";  // a function of change_sums alone
  ProgramShelf shelf;
  shelf.expect({with({"change_sums", kFlags}, signals), with({"change_weight", kFlags}, hurtsSums)});
  REQUIRE(shelf.groupOf(kSums).kernels.size() == 2);
  const DeviceKernelBuilder builder(device.context, device.device, cache, configuration, shelf);
  CHECK(builder.build("change_sums", signals).getInfo<CL_KERNEL_FUNCTION_NAME>() == "change_sums");
  CHECK(builder.build("change_weight", hurtsSums).getInfo<CL_KERNEL_FUNCTION_NAME>() == "change_weight");
  CHECK_THROWS_WITH(builder.build("change_sums", hurtsSums), Catch::Contains("change_sums"));
}

}  // namespace quell::tests
