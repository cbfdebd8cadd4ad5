#include "host/cli/kernels/kernel_list.hpp"

#include "host/core/stage.hpp"
#include "host/methods/method.hpp"

namespace quell::cli {
namespace {

/// Writes down what it is asked for.
class RecordingKernelBuilder : public KernelBuilder {
 public:
  RecordingKernelBuilder(const Configuration& configuration, std::vector<KernelUse>& uses)
      : KernelBuilder(configuration), m_uses(uses) {}

  std::size_t maxWorkGroup(const cl::Kernel&) const override { return configuration().device.maxWorkGroup; }

 protected:
  cl::Kernel compile(const std::string& stem, const std::string& options) const override {
    m_uses.push_back({stem, options});
    return {};
  }

 private:
  std::vector<KernelUse>& m_uses;
};

}  // namespace

std::vector<KernelUse> listKernels(Configuration configuration) {
  const Method& method = findMethod(configuration.settings.method());
  configuration.runtime = method.runtimeSettings(configuration.settings);
  std::vector<KernelUse> uses;
  const RecordingKernelBuilder builder(configuration, uses);
  const Schedule schedule = method.makeSchedule(configuration);
  for (const StageRow& row : schedule) row.stage->build(builder);
  return uses;
}

}  // namespace quell::cli
