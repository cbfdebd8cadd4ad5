// quell kernels: the list that offline compilers work from.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "host/cli/kernels/variants.hpp"
#include "quell/quell.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

using nlohmann::json;

constexpr int kLanesOfGpus = 1;
constexpr std::size_t kWorkGroup = 256;

cli::KernelVariants variantsOf(const std::string& method, cli::ImageSets images) {
  cli::KernelVariants variants;
  cli::addKernelVariants(variants, method, images, kLanesOfGpus, kWorkGroup);
  return variants;
}

bool hasOption(const cli::KernelVariants& variants, const std::string& stem, const std::string& option) {
  return std::any_of(variants.begin(), variants.end(), [&](const auto& variant) {
    return variant.first.first == stem && variant.first.second.find(option) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("the list has every method, every choice of its settings and every image set", "[cli]") {
  for (const std::string& method : methodNames()) {
    INFO(method);
    CHECK(hasOption(variantsOf(method, cli::ImageSets::Typical), "remodulate", "QUELL_LANES=1"));
  }
  const cli::KernelVariants typical = variantsOf("bmfr", cli::ImageSets::Typical);
  for (const char* tile : {"GRAM_TILE_EDGE=8", "GRAM_TILE_EDGE=16", "GRAM_TILE_EDGE=32"})
    CHECK(hasOption(typical, "gram_sums", tile));
  for (const char* storage : {"FIT_STORAGE_HALF=0", "FIT_STORAGE_HALF=1"})
    CHECK(hasOption(typical, "fit", storage));
  for (const char* signals : {"QUELL_SIGNALS=1", "QUELL_SIGNALS=2"})
    CHECK(hasOption(typical, "accumulate_noisy", signals));
  CHECK_FALSE(hasOption(typical, "accumulate_noisy", "VIEWDEPTH_FORMAT=1"));
  CHECK(hasOption(variantsOf("bmfr", cli::ImageSets::All), "accumulate_noisy", "VIEWDEPTH_FORMAT=1"));
  CHECK_THROWS_AS(variantsOf("magic", cli::ImageSets::Typical), Error);
}

TEST_CASE("features come on top of the other choices, where a method fits any", "[cli]") {
  const auto listed = [](const char* method, const char* features) {
    cli::KernelVariants variants;
    cli::addKernelVariants(variants, method, cli::ImageSets::Typical, kLanesOfGpus, kWorkGroup, features);
    return variants;
  };
  CHECK_FALSE(hasOption(listed("bmfr", ""), "material_guides", "QUELL_LANES=1"));
  CHECK(hasOption(listed("bmfr", "n,roughness"), "material_guides", "QUELL_LANES=1"));
  CHECK(listed("svgf", "n,roughness") == listed("svgf", ""));
  CHECK_THROWS_AS(listed("bmfr", "magic"), Error);
}

TEST_CASE("kernels writes options and complete sources", "[cli]") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("kernels.json");
  const char* arguments[] = {"quell",     "kernels", "--methods", "atrous",
                             "--mapping", "wide16",  "--json",    file.c_str()};
  REQUIRE(cli::runTool(8, arguments) == 0);
  const json list = readJson(file);
  REQUIRE_FALSE(list.at("kernels").empty());
  for (const json& kernel : list.at("kernels")) {
    CHECK(kernel.at("methods") == json::array({"atrous"}));
    CHECK(kernel.at("options").get<std::string>().find("-D QUELL_LANES=16") != std::string::npos);
    const std::string source = list.at("sources").at(kernel.at("stem").get<std::string>());
    CHECK(source.find("__kernel") != std::string::npos);
    CHECK(source.find("#include \"") == std::string::npos);
  }
}

}  // namespace quell::tests
