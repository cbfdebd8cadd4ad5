#include "host/cli/kernels/kernel_list.hpp"

#include "host/methods/method.hpp"

namespace quell::cli {

std::vector<KernelUse> listKernels(Configuration configuration) {
  const Method& method = findMethod(configuration.settings.method());
  configuration.runtime = method.runtimeSettings(configuration.settings);
  std::vector<KernelUse> uses;
  const Schedule schedule = method.makeSchedule(configuration);
  for (const StageRow& row : schedule)
    for (const KernelUse& use : kernelUses(*row.stage, configuration)) uses.push_back(use);
  return uses;
}

}  // namespace quell::cli
