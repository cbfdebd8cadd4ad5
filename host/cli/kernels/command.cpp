// quell kernels: what the methods compile, for offline compilers.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <quell/quell.hpp>
#include <set>
#include <string>
#include <vector>

#include "host/cli/common/commands.hpp"
#include "host/cli/kernels/variants.hpp"
#include "host/core/device_traits.hpp"
#include "host/core/kernel_sources.hpp"
#include "host/io/atomic_file.hpp"

namespace quell::cli {
namespace {

using nlohmann::json;

// What every GPU of the last ten years allows.
constexpr std::size_t kGpuWorkGroup = 256;
// PoCL's limit.
constexpr std::size_t kCpuWorkGroup = 4096;

struct KernelsOptions {
  std::vector<std::string> methods = methodNames();
  std::vector<std::string> features;
  std::string mapping = "narrow";
  std::string images = "typical";
  std::string json;
};

json toJson(const KernelVariants& variants) {
  json kernels = json::array(), sources = json::object();
  for (const auto& [kernel, methods] : variants) {
    const auto& [stem, options] = kernel;
    kernels.push_back({{"stem", stem}, {"options", options}, {"methods", methods}});
    sources[stem] = kernelSources().at(stem);
  }
  return {{"kernels", kernels}, {"sources", sources}};
}

std::vector<std::string> fixedMappings() {
  std::vector<std::string> names;
  for (const MappingFacts& facts : kMappings)
    if (facts.lanes > 0) names.emplace_back(facts.name);
  return names;
}

void runKernels(const KernelsOptions& options) {
  const int lanes = mappingNamed(options.mapping)->lanes;  // the option takes no other names
  const bool wide = lanes != kNarrowLanes;
  const ImageSets images = options.images == "all" ? ImageSets::All : ImageSets::Typical;
  KernelVariants variants;
  std::vector<std::string> features = options.features;
  features.insert(features.begin(), "");  // the default
  for (const std::string& method : options.methods)
    for (const std::string& list : features)
      addKernelVariants(variants, method, images, lanes, wide ? kCpuWorkGroup : kGpuWorkGroup, list);
  if (!options.json.empty()) io::writeTextFile(options.json, toJson(variants).dump(1) + "\n");
  for (const auto& [kernel, methods] : variants)
    fmt::print("{} ({}): {}\n", kernel.first, fmt::join(methods, ", "), kernel.second);
}

}  // namespace

void addKernelsCommand(CLI::App& app) {
  auto options = std::make_shared<KernelsOptions>();
  CLI::App* command = app.add_subcommand(
      "kernels", "List what the methods compile, with all compile options, for offline compilers");
  command->add_option("--methods", options->methods, "Methods to list")->delimiter(',');
  command
      ->add_option("--features", options->features,
                   "Lists of features of bmfr's fit besides the default, separated by semicolons")
      ->delimiter(';');
  command
      ->add_option("--mapping", options->mapping,
                   "Pixels per work-item: 1 (narrow, GPUs), 4, 8 or 16 (wide4, wide8, wide16, CPUs)")
      ->check(CLI::IsMember(fixedMappings()))
      ->capture_default_str();
  command
      ->add_option("--images", options->images,
                   "Typical: every optional image as float3; all: also half4, and only what is required")
      ->check(CLI::IsMember({"typical", "all"}))
      ->capture_default_str();
  command->add_option("--json", options->json, "File for the list with the kernels' sources");
  command->callback([options] { runKernels(*options); });
}

}  // namespace quell::cli
